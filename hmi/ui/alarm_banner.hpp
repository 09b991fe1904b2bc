// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include "hmi/ui/bench.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;
class QPushButton;

namespace psicarve::ui {

class ActionButton;

/// What has stopped the machine, or what nobody can stop from here, where, why, and what to do. Only there
/// while there is something of that kind.
class AlarmBanner : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::AlarmBanner)
public:
    explicit AlarmBanner(Bench& bench, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();

private:
    void back_off();
    void refresh_buttons();

    Bench& bench_;
    QLabel* icon_;
    QLabel* title_;
    QLabel* detail_;
    QLabel* steps_;
    ActionButton* back_off_;
    ActionButton* reset_;
    QPushButton* acknowledge_;
    QLabel* reason_;
};

}  // namespace psicarve::ui
