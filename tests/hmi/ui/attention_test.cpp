// SPDX-License-Identifier: GPL-3.0-or-later
// What the window wants an operator to look at: before a start, at an alarm, of the time before it was there.
#include <gtest/gtest.h>
#include <signal.h>

#include <QLabel>
#include <QSlider>
#include <QTabWidget>
#include <QTableWidget>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hmi/session/preflight.hpp"
#include "shared/file/atomic_file.hpp"
#include "tests/fake_port/fake_port_file.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/two_process/slow_machine.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class Attention : public test::WindowRig {
protected:
    QString text(const char* label) { return part<QLabel>(label).text(); }
    void home_with_a_job() {
        start_core();
        open_window();
        ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
        ASSERT_TRUE(click("home"));
        ASSERT_TRUE(comes_to(S::ready));
    }
};

TEST_F(Attention, IsAskedBeforeAStartThatIsPossible) {
    ASSERT_NO_FATAL_FAILURE(home_with_a_job());
    ASSERT_TRUE(comes_true([&] { return button("start").isEnabled(); }));
    EXPECT_FALSE(text("preflight_sum").contains("to look at"));
    EXPECT_EQ(text("reason"), "Hold, Resume, Stop: nothing is moving.");
    const auto icon_of = [&](const QString& check) {
        for (int row = 0; row < static_cast<int>(session::kMostChecks); ++row) {
            const auto name = QString{"preflight_name_%1"}.arg(row).toStdString();
            if (text(name.c_str()) != check) continue;
            return part<QLabel>(QString{"preflight_icon_%1"}.arg(row).toStdString().c_str()).accessibleName();
        }
        return QString{};
    };
    EXPECT_EQ(icon_of("Feed override"), "passed");
    part<QSlider>("override").setValue(80);
    ASSERT_TRUE(comes_true([&] { return machine_view().status->override_percent == 80; }));
    ASSERT_TRUE(comes_true([&] { return text("preflight_sum").endsWith("pass, 1 to look at"); }))
        << text("preflight_sum").toStdString();
    EXPECT_EQ(icon_of("Feed override"), "to look at");
    EXPECT_TRUE(button("start").isEnabled());
    EXPECT_EQ(text("reason"), "To be looked at before Start: Feed override: 80 %");
    take_picture("look_before_start_light");
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_FALSE(text("reason").contains("before Start"));
}

// Where the job's panel is a page that is not seen.
TEST_F(Attention, IsAskedBesideTheButtonsOfASmallWindow) {
    ASSERT_NO_FATAL_FAILURE(home_with_a_job());
    window_->resize(960, 515);
    ASSERT_TRUE(comes_true([&] { return button("motion_start").isEnabled(); }));
    auto& line = part<QLabel>("motion_reason");
    ASSERT_TRUE(line.isVisible());
    EXPECT_EQ(line.toolTip(), "Hold, Resume, Stop: nothing is moving.");
    part<QSlider>("override").setValue(80);
    EXPECT_TRUE(comes_true([&] { return line.toolTip().contains("Feed override: 80 %"); }))
        << line.toolTip().toStdString();
    EXPECT_EQ(line.toolTip(), text("reason"));
    EXPECT_TRUE(line.text().startsWith("To be looked at before Start: Feed")) << line.text().toStdString();
    take_picture("look_before_start_small_light");
    ASSERT_TRUE(click("motion_start"));
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_FALSE(line.toolTip().contains("before Start"));
}

TEST_F(Attention, IsCalledByASoundAtAnAlarmWithoutATime) {
    open_window();
    int rung = 0;
    window_->context().bell.set_ring([&rung] { ++rung; });
    // That no core is there was seen.
    ASSERT_TRUE(comes_true([looks = 0]() mutable { return ++looks > 30; }));
    // Nobody looks while it begins and stops.
    start_core();
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(S::alarm));
    ASSERT_TRUE(comes_to(S::alarm));
    ASSERT_NE(machine_view().status->is_virtual_clock, 0);
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Emergency stop"); }));
    EXPECT_FALSE(all_messages().contains("Before this window was there")) << all_messages().toStdString();
    EXPECT_TRUE(comes_true([&] { return rung == 1; }));
    // The next window finds that core there.
    open_window();
    window_->context().bell.set_ring([&rung] { ++rung; });
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Before this window was there"); }));
    EXPECT_EQ(rung, 1);
}

TEST_F(Attention, IsCalledByASoundAtANewAlarmAlone) {
    start_core();
    open_window();
    int rung = 0;
    window_->context().bell.set_ring([&rung] { ++rung; });
    ASSERT_TRUE(comes_to(S::off));
    window_->emergency_stop();
    ASSERT_TRUE(comes_to(S::alarm));
    ASSERT_TRUE(comes_true([&] { return rung == 1; }));
    // The next window finds it latched.
    open_window();
    window_->context().bell.set_ring([&rung] { ++rung; });
    ASSERT_TRUE(comes_to(S::alarm));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Before this window was there"); }));
    EXPECT_EQ(rung, 1);
    ASSERT_TRUE(click("reset_alarm"));
    ASSERT_TRUE(comes_to(S::off));
    button("alarm_sound").click();
    window_->emergency_stop();
    ASSERT_TRUE(comes_to(S::alarm));
    EXPECT_EQ(rung, 1) << "it is off";
    ASSERT_TRUE(click("reset_alarm"));
    ASSERT_TRUE(comes_to(S::off));
    button("alarm_sound").click();
    window_->emergency_stop();
    ASSERT_TRUE(comes_true([&] { return rung == 2; }));
}

TEST_F(Attention, TellsOnceOfEachAlarmOfTheTimeBeforeTheWindow) {
    start_core();
    open_window();
    ASSERT_TRUE(comes_to(S::off));
    for (int alarm = 0; alarm < 2; ++alarm) {
        window_->emergency_stop();
        ASSERT_TRUE(comes_to(S::alarm));
        ASSERT_TRUE(click("reset_alarm"));
        ASSERT_TRUE(comes_to(S::off));
    }
    EXPECT_FALSE(all_messages().contains("Before this window"));
    for (int another = 0; another < 2; ++another) {
        open_window();
        ASSERT_TRUE(comes_to(S::off));
        part<QTabWidget>("tabs").setCurrentIndex(5);
        // The core is silent for a while, and heard again.
        core_->send_signal(SIGSTOP);
        ASSERT_TRUE(comes_true([&] { return !machine_view().is_heard(); }));
        core_->send_signal(SIGCONT);
        ASSERT_TRUE(comes_true([&] { return all_messages().contains("heard again"); }));
        const QAbstractItemModel& messages = *part<QTableView>("messages").model();
        const auto cell = [&](int row, int column) { return messages.index(row, column).data().toString(); };
        int told = 0;
        for (int row = 0; row < messages.rowCount(); ++row) {
            if (cell(row, 3) != "Before this window was there: Emergency stop") continue;
            ++told;
            EXPECT_EQ(cell(row, 1), "Alarm");
            EXPECT_EQ(cell(row, 4), "Reset alarm");
        }
        EXPECT_EQ(told, 2) << all_messages().toStdString();
    }
    take_picture("messages_from_before_light");
}

TEST_F(Attention, IsToldWhyEachButtonOfTheAlarmIsLocked) {
    start_core();
    open_window();
    ASSERT_TRUE(comes_to(S::off));
    window_->emergency_stop();
    ASSERT_TRUE(comes_to(S::alarm));
    ASSERT_TRUE(comes_true([&] { return button("reset_alarm").isEnabled(); }));
    EXPECT_EQ(text("alarm_reason"), "Back off: no switch is closed");
    take_picture("alarm_reasons_light");
    ASSERT_TRUE(click("reset_alarm"));
    ASSERT_TRUE(comes_to(S::off));
    EXPECT_EQ(text("alarm_reason"), "Back off: there is no alarm\nReset alarm: there is no alarm");
}

/// On /dev/parportN, whose ioctls a preloaded library answers.
class OnAPort : public Attention {
protected:
    ~OnAPort() override {
        // The program that was started is its guard's parent, the core a child of its own.
        const auto core_pid = static_cast<pid_t>(machine_view().core_pid);
        if (core_pid > 1) kill(core_pid, SIGKILL);
    }
    void start_port_core() {
        const std::string toml = profile_to_toml(profile_);
        ASSERT_TRUE(write_file_atomically(file("machine.toml"), std::as_bytes(std::span{toml})));
        const fake_port::FakePortFile::Preload preload{port_};
        core_ = std::make_unique<two_process::CoreProcess>(
            std::vector<std::string>{"--segment", segment_name_, "--clock", "real", "--profile",
                                     file("machine.toml"), "--port", "ppdev:" + port_.device(), "--capacity",
                                     "100x20", "--allow-no-realtime"},
            file("core.err"));
    }

    Profile profile_ = two_process::slow_machine();
    fake_port::FakePortFile port_{file(""), profile_};
};

TEST_F(OnAPort, TheStripNamesIt) {
    ASSERT_NO_FATAL_FAILURE(start_port_core());
    open_window();
    auto& badge = part<QLabel>("badge");
    ASSERT_TRUE(comes_true([&] { return badge.isVisible(); })) << all_messages().toStdString();
    EXPECT_EQ(badge.text().toStdString(), port_.device().substr(port_.device().rfind('/') + 1));
    EXPECT_EQ(badge.toolTip().toStdString(), "The real machine at port ppdev:" + port_.device());
    EXPECT_EQ(badge.property("role").toString(), "port") << "it is no toy";
    take_picture("real_port_light");
}

}  // namespace
}  // namespace psicarve::ui
