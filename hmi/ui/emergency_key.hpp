// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

#include "hmi/ui/main_window.hpp"

namespace psicarve::ui {

/// F1, in whatever window or dialog of the program it is pressed.
class MainWindow::EmergencyKey : public QObject {
public:
    explicit EmergencyKey(std::function<void()> act);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<void()> act_;
};

}  // namespace psicarve::ui
