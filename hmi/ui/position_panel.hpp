// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <array>

#include "hmi/session/axis_actions.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

namespace psicarve::ui {

class ActionButton;
class OrderCard;

/// Where the axes are, whether they know it, and their sensors. One axis is selected: Home and Zero are of
/// it.
class PositionPanel : public Dock {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PositionPanel)
public:
    explicit PositionPanel(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// As they are kept; they may have come late.
    void take_zeros();
    void set_room(Room room);

private:
    struct Row {
        QFrame* whole;
        QFrame* bar;
        QLabel* name;
        QLabel* second;
        QLabel* value;
        QLabel* unit;
        QLabel* pulses;  ///< where there is room
        QLabel* homed;
        QLabel* sensor;
    };
    QWidget* make_row(Axis axis);
    void refresh_row(Axis axis);
    void refresh_lamps(Axis axis);
    void refresh_buttons();
    void select(Axis axis);
    bool is_zero_shown() const;
    void change_zero();
    void home_selected();
    bool is_unheard() const;
    void refresh_homed(Axis axis, bool is_homed);

    WindowContext& context_;
    std::array<Row, kAxisCount> rows_{};
    Axis selected_ = Axis::r1;
    bool is_wide_ = false;
    session::WorkZero zero_;
    ActionButton* home_;
    OrderCard* refused_ = nullptr;
    ActionButton* home_one_;
    ActionButton* zero_one_;
};

}  // namespace psicarve::ui
