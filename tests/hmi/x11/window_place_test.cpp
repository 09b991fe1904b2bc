// SPDX-License-Identifier: GPL-3.0-or-later
// The window's place on the screen, whatever ends its program.
#include <gtest/gtest.h>

#include <csignal>
#include <string>

#include "tests/hmi/x11/x11_rig.hpp"

namespace psicarve {
namespace {

using two_process::long_job;
using two_process::text_of;
using S = MachineState;

class PlaceOnAScreen : public test::X11Rig {
protected:
    std::string place() const { return ask("place"); }
    std::string settings() const { return text_of(file("psicarve/psicarve-hmi.ini")); }
    bool has_kept(const char* what) const { return settings().find(what) != std::string::npos; }
    /// Another size and another page than a window begins with; the place that it has then.
    std::string resize_and_go_to_ports() {
        resize_window(1180, 705);
        EXPECT_TRUE(says("place", " 1180 705 free"));
        EXPECT_TRUE(click("tab 3"));
        return place();
    }
    void carve_without_a_window() {
        ASSERT_EQ(publish(long_job()), "");
        home();
        start_carving();
    }
    /// The window shows what it showed before, and the machine is as if nothing had been.
    void expect_back_at(const std::string& before) {
        open_window();
        EXPECT_TRUE(says("place", before));
        EXPECT_EQ(ask("current tabs"), "3");
        EXPECT_EQ(status().state, S::carving);
        EXPECT_EQ(status().alarm_count, 0U);
    }
};

TEST_F(PlaceOnAScreen, ComesBackAfterASignalToEndWhichAsksNothingAndLeavesTheJobAlone) {
    start_core();
    carve_without_a_window();
    for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
        open_window();
        ASSERT_TRUE(says("text state_pill", "CARVING"));
        const std::string before = resize_and_go_to_ports();
        window_->send_signal(number);
        ASSERT_EQ(window_->wait(), 0) << number << text_of(file("window.log"));
        expect_back_at(before);
        window_->kill_now();
        std::remove(file("psicarve/psicarve-hmi.ini").c_str());
    }
}

TEST_F(PlaceOnAScreen, ComesBackAfterASignalBesideAQuestion) {
    start_core();
    carve_without_a_window();
    open_window();
    ASSERT_TRUE(says("text state_pill", "CARVING"));
    const std::string before = resize_and_go_to_ports();
    press({"ctrl+q"});
    ASSERT_TRUE(says("modal", "Close the window"));
    window_->send_signal(SIGTERM);
    ASSERT_EQ(window_->wait(), 0) << text_of(file("window.log"));
    expect_back_at(before);
}

TEST_F(PlaceOnAScreen, ComesBackAfterADeathThatNobodyForesaw) {
    start_core();
    carve_without_a_window();
    open_window();
    ASSERT_TRUE(says("text state_pill", "CARVING"));
    const std::string before = resize_and_go_to_ports();
    ASSERT_TRUE(eventually([&] { return has_kept("page=ports"); })) << settings();
    window_->kill_now();
    expect_back_at(before);
    take_picture("back_after_death");
}

class PlaceOnASmallScreen : public PlaceOnAScreen {
protected:
    PlaceOnASmallScreen() { screen_size_ = "1280x720"; }
};

TEST_F(PlaceOnASmallScreen, IsMaximisedAtFirstForThereItHasTheUsualRoom) {
    open_window();
    EXPECT_TRUE(says("place", " maximised"));
    EXPECT_TRUE(says("text reason", "No core serves the segment")) << "the Job panel is in sight";
    take_picture("first_on_1280x720");
    press({"ctrl+q"});
    EXPECT_EQ(window_->wait(), 0);
}

}  // namespace
}  // namespace psicarve
