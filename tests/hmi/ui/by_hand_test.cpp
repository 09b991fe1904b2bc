// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>

#include <array>
#include <cmath>
#include <cstdint>

#include "tests/hmi/ui/press_log.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

constexpr int kPorts = 3;

/// What a hand does at the window, and a real core on the simulated machine.
class ByHand : public WindowRig {
protected:
    void open_homed() {
        start_core();
        open_window();
        window_->activateWindow();
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
    }
    const session::MachineView& machine_view() { return window_->context().machine.view(); }
    std::int64_t pulses(Axis axis) { return machine_view().status->position_pulses[index_of(axis)]; }
    void key(QEvent::Type type, int code, Qt::KeyboardModifiers with = Qt::NoModifier,
             bool is_repeat = false) {
        QKeyEvent event{type, code, with, QString{}, is_repeat};
        QApplication::sendEvent(window_.get(), &event);
    }
    void press(int code, Qt::KeyboardModifiers with = Qt::NoModifier) { key(QEvent::KeyPress, code, with); }
    void let_go(int code) { key(QEvent::KeyRelease, code); }
    bool is_armed() { return button("arm_keys").text() == "Disarm keyboard jog"; }
    void select(const char* axis) {
        auto* const row = window_->findChild<QWidget*>(axis);
        ASSERT_NE(row, nullptr);
        QMouseEvent click{QEvent::MouseButtonPress, QPointF{20, 20}, QPointF{20, 20},
                          Qt::LeftButton,           Qt::LeftButton,  Qt::NoModifier};
        QApplication::sendEvent(row, &click);
    }
};

TEST_F(ByHand, KeysMoveTheMachineOnlyWhileTheyAreArmed) {
    open_homed();
    const auto from_pulses = pulses(Axis::y);
    press(Qt::Key_Up);
    let_go(Qt::Key_Up);
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_EQ(pulses(Axis::y), from_pulses);
    ASSERT_TRUE(click("arm_keys"));
    EXPECT_TRUE(is_armed());
    EXPECT_TRUE(window_->findChild<QLabel*>("jog_keys")->isVisible());
    take_picture("keys_armed_light");
    press(Qt::Key_Up);
    ASSERT_TRUE(comes_true([&] { return pulses(Axis::y) > from_pulses; })) << all_messages().toStdString();
    key(QEvent::KeyPress, Qt::Key_Up, Qt::NoModifier, true);
    key(QEvent::KeyRelease, Qt::Key_Up, Qt::NoModifier, true);
    EXPECT_EQ(machine_view().state(), S::moving);
    let_go(Qt::Key_Up);
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(click("arm_keys"));
    EXPECT_FALSE(is_armed());
    EXPECT_FALSE(window_->findChild<QLabel*>("jog_keys")->isVisible());
}

TEST_F(ByHand, EveryKeyMovesItsAxisByAStepItsWay) {
    open_homed();
    ASSERT_TRUE(click("arm_keys"));
    test::PressLog::instance().hear_first();  // armed, the window keeps these keys to itself
    struct Key {
        int code;
        Qt::KeyboardModifiers with;
        Axis axis;
        std::int64_t way_pulses;
    };
    constexpr int kStep_pulses = 40;  // 0.1 mm
    const auto degree_pulses = std::llround(axis_motion(Profile{}, Axis::psi).pulses_per_unit);
    // Homed heads stand outside: in before out.
    for (const Key one : {Key{Qt::Key_PageDown, Qt::NoModifier, Axis::r1, -kStep_pulses},
                          Key{Qt::Key_PageUp, Qt::NoModifier, Axis::r1, kStep_pulses},
                          Key{Qt::Key_PageDown, Qt::ControlModifier, Axis::r2, -kStep_pulses},
                          Key{Qt::Key_PageUp, Qt::ControlModifier, Axis::r2, kStep_pulses},
                          Key{Qt::Key_Up, Qt::NoModifier, Axis::y, kStep_pulses},
                          Key{Qt::Key_Down, Qt::NoModifier, Axis::y, -kStep_pulses},
                          Key{Qt::Key_Right, Qt::NoModifier, Axis::psi, degree_pulses},
                          Key{Qt::Key_Left, Qt::NoModifier, Axis::psi, -degree_pulses}}) {
        auto wanted = std::to_array(machine_view().status->position_pulses);
        wanted[index_of(one.axis)] += one.way_pulses;
        press(one.code, one.with | Qt::ShiftModifier);
        ASSERT_TRUE(comes_true([&] {
            return machine_view().state() == S::ready &&
                   std::to_array(machine_view().status->position_pulses) == wanted;
        })) << name_of(one.axis)
            << ' ' << one.way_pulses << all_messages().toStdString();
    }
}

TEST_F(ByHand, ArmedKeysAreDisarmedByATextFieldADialogAndTheEmergencyStop) {
    open_homed();
    ASSERT_TRUE(click("arm_keys"));
    const auto from_pulses = pulses(Axis::y);
    press(Qt::Key_Up);
    ASSERT_TRUE(comes_true([&] { return pulses(Axis::y) > from_pulses; }));
    window_->findChild<QSpinBox*>("layers")->setFocus();
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_FALSE(is_armed());
    ASSERT_TRUE(click("arm_keys"));
    {
        QMessageBox dialog{window_.get()};
        dialog.setObjectName("test_question");
        dialog.setModal(true);
        dialog.open();
        QApplication::processEvents();
        const auto before = pulses(Axis::y);
        press(Qt::Key_Down);
        EXPECT_FALSE(
            comes_true([&] { return machine_view().state() == S::moving; }, std::chrono::milliseconds{300}));
        EXPECT_EQ(pulses(Axis::y), before);
    }
    if (!is_armed()) {
        ASSERT_TRUE(click("arm_keys"));
    }
    window_->emergency_stop();
    EXPECT_FALSE(is_armed());
    ASSERT_TRUE(comes_to(S::alarm));
    EXPECT_FALSE(button("arm_keys").isEnabled());
    EXPECT_EQ(button("arm_keys").toolTip(), "Locked until the alarm is reset");
}

TEST_F(ByHand, JogsBothHeadsInAndOut) {
    open_homed();
    const auto r1_pulses = pulses(Axis::r1);
    const auto r2_pulses = pulses(Axis::r2);
    EXPECT_EQ(button("jog_heads_in").toolTip(), "Both heads in");
    ASSERT_TRUE(click("jog_heads_in"));
    ASSERT_TRUE(comes_true([&] {
        return pulses(Axis::r2) == r2_pulses - 40 && machine_view().state() == S::ready;
    })) << all_messages().toStdString();
    EXPECT_EQ(pulses(Axis::r1), r1_pulses - 40);
    button("jog_heads_in").setDown(true);
    Q_EMIT button("jog_heads_in").pressed();
    ASSERT_TRUE(comes_true([&] { return pulses(Axis::r1) < r1_pulses - 200; }))
        << all_messages().toStdString();
    Q_EMIT button("jog_heads_in").released();
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_EQ(pulses(Axis::r1) - r1_pulses, pulses(Axis::r2) - r2_pulses);
}

TEST_F(ByHand, HomesTheSelectedAxisAlone) {
    start_core();
    open_window();
    select("axis_psi");
    ASSERT_TRUE(comes_true([&] { return button("home_one").text() == "Home Ψ"; }));
    ASSERT_TRUE(comes_true([&] { return button("home_one").toolTip() == "Home Ψ: home R1 and R2 first"; }));
    for (const auto& [row, mask] :
         {std::pair{"axis_r2", 0b0010}, {"axis_r1", 0b0011}, {"axis_psi", 0b0111}}) {
        select(row);
        ASSERT_TRUE(click("home_one"));
        ASSERT_TRUE(comes_true([&, mask = mask] {
            return machine_view().status->homed_mask == mask && machine_view().state() == S::off;
        })) << row
            << all_messages().toStdString();
    }
    select("axis_y");
    ASSERT_TRUE(click("home_one"));
    ASSERT_TRUE(comes_to(S::ready));
}

TEST_F(ByHand, AZeroIsShownKeptAndForgottenAndMovesNothing) {
    open_homed();
    select("axis_y");
    const auto from_pulses = pulses(Axis::y);
    ASSERT_TRUE(click("jog_y_up"));
    ASSERT_TRUE(comes_true(
        [&] { return machine_view().state() == S::ready && pulses(Axis::y) == from_pulses + 40; }));
    auto* const second = window_->findChild<QLabel*>("second_y");
    EXPECT_EQ(second->text(), "height");
    const auto stands_pulses = pulses(Axis::y);
    const QString machine = window_->findChild<QLabel*>("position_y")->text();
    ASSERT_TRUE(click("zero_one"));
    EXPECT_EQ(second->text(), "Δ 0.00");
    EXPECT_EQ(button("zero_one").text(), "No zero");
    ASSERT_TRUE(click("jog_y_up"));
    ASSERT_TRUE(comes_true([&] { return second->text() == "Δ 0.10"; }));
    EXPECT_EQ(pulses(Axis::y), stands_pulses + 40);
    take_picture("zero_light");
    open_window();
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_EQ(window_->findChild<QLabel*>("second_y")->text(), "Δ 0.10") << "kept";
    select("axis_y");
    ASSERT_TRUE(click("zero_one"));
    ASSERT_TRUE(click("zero_one"));
    EXPECT_EQ(window_->findChild<QLabel*>("second_y")->text(), "height") << "forgotten";
    EXPECT_EQ(pulses(Axis::y), stands_pulses + 40);
    EXPECT_NE(window_->findChild<QLabel*>("position_y")->text(), machine);
}

// A zero is an angle: the turns are the machine's own before it and after it.
TEST_F(ByHand, TheTableTellsItsTurnsWhateverItsZero) {
    open_homed();
    auto* const second = window_->findChild<QLabel*>("second_psi");
    auto* const position = window_->findChild<QLabel*>("position_psi");
    const std::int64_t per_rev = machine_view().profile->psi.pulses_per_rev;
    Command turn{};
    turn.kind = CommandKind::jog;
    turn.axis = static_cast<std::uint32_t>(index_of(Axis::psi));
    turn.value = 2 * 360.0 + 90.0;
    turn.lease_token = 7;
    turn.lease_ms = 2000;
    const std::int64_t begin_pulses = pulses(Axis::psi);
    window_->context().machine.order(turn, session::phrase("Turn"));
    ASSERT_TRUE(comes_true([&] { return pulses(Axis::psi) > begin_pulses; })) << all_messages().toStdString();
    ASSERT_TRUE(comes_to(S::ready));
    const std::int64_t turns = pulses(Axis::psi) / per_rev;
    ASSERT_GT(turns, 1);
    const QString told = QString{"%1 turns"}.arg(turns);
    EXPECT_EQ(second->text(), told);
    const QString angle = position->text();
    select("axis_psi");
    ASSERT_TRUE(click("zero_one"));
    EXPECT_EQ(second->text(), "Δ 0.00\n" + told);
    EXPECT_EQ(position->text(), angle) << "the machine's own, 0 to 360";
    take_picture("zero_of_psi_light");
    ASSERT_TRUE(click("zero_one"));
    EXPECT_EQ(second->text(), told);
}

TEST_F(ByHand, TestsTheWiringOfOneOutputWithTheDrivesOff) {
    open_homed();
    window_->findChild<QTabWidget*>()->setCurrentIndex(kPorts);
    ASSERT_TRUE(comes_true([&] { return !button("arm_wiring").isEnabled(); }));
    EXPECT_EQ(button("arm_wiring").toolTip(), "Wiring test: switch the drives off first");
    ASSERT_TRUE(click("drives_off"));
    ASSERT_TRUE(comes_to(S::off));
    EXPECT_EQ(machine_view().status->homed_mask, 0);
    EXPECT_FALSE(button("hold_high").isVisible());
    ASSERT_TRUE(click("arm_wiring"));
    auto* const outputs = window_->findChild<QComboBox*>("test_output");
    outputs->setCurrentIndex(outputs->findData(static_cast<int>(index_of(Signal::spindle))));
    button("hold_high").setDown(true);
    Q_EMIT button("hold_high").pressed();
    ASSERT_TRUE(comes_true([&] {
        return (machine_view().status->signals & kOutputMask) == bit_of(Signal::spindle);
    })) << all_messages().toStdString();
    EXPECT_EQ(machine_view().state(), S::testing);
    auto* const pins = window_->findChild<QTableWidget*>("pins");
    EXPECT_LE(pins->verticalHeader()->length(), pins->viewport()->height()) << "every input is in sight";
    EXPECT_EQ(button("start").toolTip(), "Start: an output is tested");
    take_picture("wiring_light");
    Q_EMIT button("hold_high").released();
    button("hold_high").setDown(false);
    ASSERT_TRUE(comes_to(S::off));
    EXPECT_EQ(machine_view().status->signals & kOutputMask, 0U);
    outputs->setCurrentIndex(outputs->findData(static_cast<int>(index_of(Signal::r2_step))));
    window_->findChild<QSpinBox*>("test_pulses")->setValue(30);
    ASSERT_TRUE(click("send_pulses"));
    ASSERT_TRUE(comes_true([&] {
        return machine_view().status->sim_ignored_pulses[index_of(Axis::r2)] == 30 &&
               machine_view().state() == S::off;
    })) << all_messages().toStdString();
    ASSERT_TRUE(click("arm_wiring"));
    EXPECT_TRUE(comes_true([&] { return !button("hold_high").isVisible(); }));
}

}  // namespace
}  // namespace psicarve::ui
