// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTimer>

#include <functional>
#include <utility>
#include <vector>

#include "hmi/session/keyboard_jog.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/window_context.hpp"

class QButtonGroup;
class QGridLayout;
class QSlider;
class QStackedWidget;

namespace psicarve::ui {

class MoveDialog;
class OrderCard;

/// Moves one axis by hand: a click is a step, holding the button goes on until it is let go. Likewise with
/// the keyboard, while that is armed. Its members: widgets, and the press that is under way.
class JogPanel : public Dock {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::JogPanel)
public:
    explicit JogPanel(WindowContext& context, QWidget* parent = nullptr);
    ~JogPanel() override;

    void set_theme(const Tokens& tokens);
    void refresh();
    /// Whatever is held is let go, and keys mean nothing any more: the window lost the focus, or a dialog
    /// opens.
    void let_go();
    void go_to();
    void turn_spindle();
    /// Told whenever keys begin or cease to move the machine.
    void set_on_armed(std::function<void(bool)> armed) { on_armed_ = std::move(armed); }
    /// Keys while they are armed.
    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Key {
        ActionButton* button;
        machine::JogAxis axis;
        bool up;
        std::optional<Glyph> glyph;
    };
    QWidget* step_row(const QString& unit, const std::vector<double>& steps, QButtonGroup*& group,
                      int chosen);
    QLayout* speed_row(const QString& name, QSlider*& slider, QLabel*& label);
    void add_key(const QString& text, machine::JogAxis axis, bool up, std::optional<Glyph> glyph,
                 const char* name);
    void make_heads_keys(QGridLayout& pad);
    void follow_fields();
    void press(const Key& key);
    void release();
    // jog_panel_keys.cpp
    void make_arm_button();
    void make_more_buttons();
    void arm();
    void disarm();
    void show_armed();
    void follow(const session::KeyboardJog::Order& order);
    double speed_of(machine::JogAxis axis) const;
    double step_of(machine::JogAxis axis) const;

    WindowContext& context_;
    std::vector<Key> keys_;
    QButtonGroup* linear_steps_ = nullptr;
    QButtonGroup* angular_steps_ = nullptr;
    QSlider* linear_speed_ = nullptr;
    QSlider* angular_speed_ = nullptr;
    QLabel* linear_label_ = nullptr;
    QLabel* angular_label_ = nullptr;
    QLabel* hint_;
    QStackedWidget* more_ = nullptr;  ///< further buttons; while keys are armed, what they do
    ActionButton* arm_ = nullptr;
    ActionButton* go_to_ = nullptr;
    ActionButton* spindle_ = nullptr;
    MoveDialog* move_ = nullptr;
    OrderCard* refused_ = nullptr;
    session::KeyboardJog keyboard_;
    std::function<void(bool)> on_armed_;
    QTimer hold_timer_;  ///< runs while a press may still become a click
    machine::JogAxis pressed_axis_ = Axis::r1;
    bool pressed_up_ = true;
    bool is_held_ = false;
};

}  // namespace psicarve::ui
