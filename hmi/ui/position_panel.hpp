// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <array>

#include "hmi/ui/bench.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

class ActionButton;

/// Where the axes are, whether they know it, and their sensors.
class PositionPanel : public Dock {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PositionPanel)
public:
    explicit PositionPanel(Bench& bench, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();

private:
    struct Row {
        QFrame* bar;
        QLabel* name;
        QLabel* second;
        QLabel* value;
        QLabel* unit;
        QLabel* homed;
        QLabel* sensor;
    };
    QWidget* make_row(Axis axis);
    void refresh_row(Axis axis);
    void refresh_lamps(Axis axis);

    Bench& bench_;
    std::array<Row, kAxisCount> rows_{};
    ActionButton* home_;
    ActionButton* home_y_;
};

}  // namespace psicarve::ui
