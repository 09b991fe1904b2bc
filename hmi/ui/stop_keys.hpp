// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

#include "hmi/ui/main_window.hpp"

class QKeyEvent;

namespace psicarve::ui {

/// F1 and Esc, in whatever window, dialog or menu of the program they are pressed.
class MainWindow::StopKeys : public QObject {
public:
    /// Esc is a stop while `may_stop`, but in a dialog that keeps it; else it is whatever it is anywhere: a
    /// dialog closes.
    StopKeys(std::function<void()> emergency_stop, std::function<bool()> may_stop,
             std::function<void()> stop);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Null: the key is not ours now.
    const std::function<void()>* action_of(int key, const QObject& watched) const;

    std::function<void()> emergency_stop_;
    std::function<bool()> may_stop_;
    std::function<void()> stop_;
};

}  // namespace psicarve::ui
