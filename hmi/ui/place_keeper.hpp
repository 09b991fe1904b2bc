// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <functional>

class QWidget;

namespace psicarve::ui {

/// Has kept where windows stand soon after the last of a row of changes: whatever ends the program, it comes
/// back where it was.
class PlaceKeeper : public QObject {
public:
    explicit PlaceKeeper(std::function<void()> keep);

    /// Moved, resized, maximised.
    void watch(QWidget& window);
    void keep_soon() { soon_.start(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QTimer soon_;
};

}  // namespace psicarve::ui
