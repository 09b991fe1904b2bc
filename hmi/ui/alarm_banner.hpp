// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include "hmi/ui/bench.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;

namespace psicarve::ui {

class ActionButton;

/// What has stopped the machine, where, why, and what to do. Only there while there is an alarm.
class AlarmBanner : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::AlarmBanner)
public:
    explicit AlarmBanner(Bench& bench, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();

private:
    void back_off();

    Bench& bench_;
    QLabel* icon_;
    QLabel* title_;
    QLabel* detail_;
    QLabel* steps_;
    ActionButton* back_off_;
    ActionButton* reset_;
    QLabel* reason_;
};

}  // namespace psicarve::ui
