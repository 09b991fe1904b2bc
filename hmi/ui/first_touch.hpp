// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace psicarve::ui {

/// Whether the mouse or the keyboard was used on a window or what belongs to it: from then on
/// nothing moves below the hand by itself. Also whether it was drawn by its title bar, which belongs to the
/// desktop: its clicks do not come here, but the window moves again and again then; a desktop that finds a
/// place for it moves it once or twice.
class FirstTouch : public QObject {
public:
    /// `window` is to live longer.
    explicit FirstTouch(const QWidget& window);

    bool has_come() const noexcept { return has_come_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool is_ours(const QObject& watched) const;
    bool is_drawn(const QObject& watched, const QEvent& event);

    const QWidget& window_;
    bool has_come_ = false;
    int moves_ = 0;  ///< of the window, since it is seen
};

}  // namespace psicarve::ui
