// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace psicarve::ui {

/// Whether somebody has used the mouse or the keyboard on a window or what belongs to it: from then on
/// nothing moves below the hand by itself.
class FirstTouch : public QObject {
public:
    /// `window` is to live longer.
    explicit FirstTouch(const QWidget& window);

    bool has_come() const noexcept { return has_come_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool is_ours(const QObject& watched) const;

    const QWidget& window_;
    bool has_come_ = false;
};

}  // namespace psicarve::ui
