// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

#include "hmi/ui/main_window.hpp"

class QKeyEvent;

namespace psicarve::ui {

/// F1, Shift+Esc and Esc, in whatever window of the program they are pressed.
class MainWindow::StopKeys : public QObject {
public:
    struct Acts {
        std::function<void()> emergency_stop;
        std::function<bool()> may_stop;
        std::function<void()> stop;
        /// What Esc does now outside dialogs and menus; empty: nothing.
        std::function<std::function<void()>()> escape;
    };
    /// Shift+Esc stops while `may_stop`, from dialogs and menus too. Esc is there what it is in any program:
    /// it closes them.
    explicit StopKeys(Acts acts);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Empty: the key is not ours now.
    std::function<void()> action_of(const QKeyEvent& key, const QObject& watched) const;

    Acts acts_;
};

}  // namespace psicarve::ui
