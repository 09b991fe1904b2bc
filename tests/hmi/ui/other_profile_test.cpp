// SPDX-License-Identifier: GPL-3.0-or-later
// A core whose profile the window has not been given.
#include <gtest/gtest.h>

#include <QLabel>

#include <fstream>
#include <utility>

#include "hmi/session/display_text.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

class OtherProfile : public test::WindowRig {
protected:
    void start_core_with(const Profile& profile) {
        std::ofstream{file("other.toml")} << profile_to_toml(profile);
        start_core({"--profile", file("other.toml")});
    }
    std::string label() { return part<QLabel>("profile_label").text().toStdString(); }
    bool comes_to_be_called(const std::string& text) {
        return comes_true([&] { return label() == text; });
    }
    std::string unit() { return session::axis_readout(sight(), Axis::r1).unit; }
};

TEST_F(OtherProfile, IsCountedByTheJobsThatTheCoreHasAccepted) {
    Profile own;
    own.tick.missed_alarm_per_s += 1;  // nothing that moves
    std::swap(own.port.pins[index_of(Signal::r1_step)], own.port.pins[index_of(Signal::r2_step)]);
    start_core_with(own);
    open_window();
    ASSERT_TRUE(comes_true([&] { return sight().is_heard(); }));
    ASSERT_TRUE(comes_to_be_called("profile unknown")) << label();
    EXPECT_EQ(unit(), "pulses");
    publish_job(two_process::long_job());
    ASSERT_TRUE(comes_to_be_called("profile as the job's")) << label();
    EXPECT_EQ(unit(), "mm");
    EXPECT_TRUE(sight().is_profile_of_job);
    EXPECT_EQ(sight().profile->head_clearance_mm, Profile{}.head_clearance_mm);
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    ASSERT_TRUE(comes_true([&] { return !sight().is_heard(); }));
    EXPECT_EQ(unit(), "mm") << "as they were known last";
}

TEST_F(OtherProfile, IsNotTakenFromAJobThatTheCoreRefuses) {
    Profile own;
    own.r1.pulses_per_mm *= 2.0;
    start_core_with(own);
    open_window();
    ASSERT_TRUE(comes_true([&] { return sight().is_heard(); }));
    ASSERT_TRUE(comes_to_be_called("profile unknown"));
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(two_process::long_job());
    ASSERT_TRUE(save_snapshot(snapshot, file("refused.job")));
    window_->open(QString::fromStdString(file("refused.job")));
    ASSERT_TRUE(comes_to(session::DeskState::job));
    window_->bench().desk.publish();
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("refused"); }))
        << all_messages().toStdString();
    EXPECT_EQ(label(), "profile unknown");
    EXPECT_EQ(unit(), "pulses");
}

}  // namespace
}  // namespace psicarve::ui
