// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the machine when the operator's hand or eye goes elsewhere: the window is closed, another
// takes the keyboard, a dialog stands in front.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/hmi/x11/x11_rig.hpp"

namespace psicarve {
namespace {

using two_process::long_job;
using two_process::text_of;
using S = MachineState;

class HandsOnAScreen : public test::X11Rig {
protected:
    void open_while_carving() {
        start_core();
        ASSERT_EQ(publish(long_job()), "");
        home();
        start_carving();
        open_window();
        ASSERT_TRUE(says("text state_pill", "CARVING"));
    }
    void close_and_say(const std::string& choice) {
        press({"ctrl+q"});
        ASSERT_TRUE(says("modal", "Close the window"));
        ASSERT_TRUE(click("dialog " + choice));
    }
    void open_armed() {
        start_core();
        home();
        open_window();
        ASSERT_TRUE(says("text state_pill", "READY"));
        press({"F9"});
        ASSERT_TRUE(says("text arm_keys", "Disarm"));
    }
    void hold_key(const std::string& key) {
        key_down(key);
        ASSERT_TRUE(reaches(S::moving));
    }
};

TEST_F(HandsOnAScreen, ClosingTheWindowEndsAJobOnlyWhenToldTo) {
    open_while_carving();
    close_and_say("Cancel");
    ASSERT_TRUE(says("text state_pill", "CARVING"));
    press({"ctrl+q"});
    ASSERT_TRUE(says("modal", "Close the window"));
    press({"Escape"});
    ASSERT_TRUE(says("modal", "none"));
    ASSERT_TRUE(says("text state_pill", "CARVING"));
    close_and_say("Leave running");
    EXPECT_EQ(window_->wait(), 0) << text_of(file("window.log"));
    const auto points = status().points_done;
    ASSERT_TRUE(eventually([&] { return status().points_done > points; }));
    EXPECT_EQ(status().state, S::carving);
    open_window();
    ASSERT_TRUE(says("text state_pill", "CARVING"));
    close_and_say("Hold");
    EXPECT_EQ(window_->wait(), 0) << text_of(file("window.log"));
    ASSERT_TRUE(reaches(S::held));
    open_window();
    ASSERT_TRUE(says("text state_pill", "HELD"));
    EXPECT_EQ(status().state, S::held) << "an opened window moves nothing";
    close_and_say("Stop");
    EXPECT_EQ(window_->wait(), 0) << text_of(file("window.log"));
    ASSERT_TRUE(reaches(S::ready));
    EXPECT_EQ(status().alarm_count, 0U);
}

TEST_F(HandsOnAScreen, EscHoldsAJobAndShiftEscEndsIt) {
    open_while_carving();
    press({"F12"});
    ASSERT_TRUE(says("modal", "Keys"));
    press({"Escape"});
    ASSERT_TRUE(says("modal", "none"));
    ASSERT_TRUE(says("text state_pill", "CARVING"));
    press({"Escape"});
    ASSERT_TRUE(says("text state_pill", "HELD"));
    press({"Escape"});
    press({"Pause"});
    ASSERT_TRUE(says("text state_pill", "CARVING"));
    press({"F12"});
    ASSERT_TRUE(says("modal", "Keys"));
    press({"shift+Escape"});
    ASSERT_TRUE(reaches(S::ready));
    ASSERT_TRUE(says("modal", "Keys"));
    EXPECT_EQ(status().alarm_count, 0U);
}

TEST_F(HandsOnAScreen, AKeyJogsAsLongAsItIsDown) {
    open_armed();
    ASSERT_NO_FATAL_FAILURE(hold_key("Right"));
    key_up("Right");
    ASSERT_TRUE(reaches(S::ready));
    EXPECT_EQ(status().move_end, MoveEnd::released);
    EXPECT_GT(status().position_pulses[index_of(Axis::psi)], 0);
    press({"F9"});
    ASSERT_TRUE(says("text arm_keys", "Arm"));
    const auto there = status().position_pulses[index_of(Axis::psi)];
    press({"Right"});
    ASSERT_TRUE(says("text state_pill", "READY"));
    EXPECT_EQ(status().position_pulses[index_of(Axis::psi)], there) << "keys that are not armed";
}

// A click elsewhere takes the key's release with it: this window never hears of it.
TEST_F(HandsOnAScreen, AKeysJogEndsWhenAnotherWindowTakesTheKeyboard) {
    open_armed();
    const std::unique_ptr<test::ChildProcess> jogging = std::move(window_);
    ASSERT_NO_FATAL_FAILURE(hold_key("Right"));
    open_window({"--segment", segment_name_ + "-other"});  // it has the focus once it is there
    ASSERT_TRUE(reaches(S::ready));
    EXPECT_EQ(status().move_end, MoveEnd::released) << "by the window, not by its lease";
    key_up("Right");
    EXPECT_EQ(status().state, S::ready);
}

TEST_F(HandsOnAScreen, TheEmergencyStopWorksFromADialog) {
    open_while_carving();
    press({"ctrl+o"});
    ASSERT_TRUE(says("modal", "Open model, job, program or recording"));
    press({"F1"});
    ASSERT_TRUE(reaches(S::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::emergency_stop);
    EXPECT_EQ(status().signals & bit_of(Signal::spindle), 0U);
}

}  // namespace
}  // namespace psicarve
