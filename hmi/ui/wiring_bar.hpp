// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <vector>

#include "hmi/profile/pin_rows.hpp"
#include "hmi/session/wiring_trial.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/window_context.hpp"

class QComboBox;
class QLabel;
class QSpinBox;

namespace psicarve::ui {

class OrderCard;

/// The wiring test of single outputs: armed, then one output is held active or sends pulses.
class WiringBar : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::WiringBar)
public:
    explicit WiringBar(WindowContext& context, QWidget* parent = nullptr);

    void show_rows(const std::vector<session::PinRow>& rows);
    void refresh();
    void set_theme(const Tokens& tokens);
    bool is_armed() const noexcept { return test_.is_armed(); }
    /// Ends the test, whatever is held.
    void let_go();

private:
    void make_armed_row();
    void send_pulses();
    void hold(bool is_down);
    Signal output() const;
    std::optional<session::Phrase> step_lock() const;

    WindowContext& context_;
    session::WiringTrial test_;
    QLabel* text_;
    QLabel* left_;
    ActionButton* arm_;
    ActionButton* drives_off_;
    QWidget* armed_row_;
    QComboBox* outputs_;
    QSpinBox* rate_;
    QSpinBox* pulses_;
    ActionButton* send_;
    ActionButton* hold_;
    OrderCard* refused_;
};

}  // namespace psicarve::ui
