// SPDX-License-Identifier: GPL-3.0-or-later
// A core whose profile the window has not been given.
#include <gtest/gtest.h>

#include <QLabel>

#include <filesystem>
#include <fstream>
#include <utility>

#include "hmi/session/display_text.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

class OtherProfile : public test::WindowRig {
protected:
    void start_core_with(const Profile& profile) {
        std::ofstream{file("other.toml")} << profile_to_toml(profile);
        start_core({"--profile", file("other.toml")});
    }
    /// Then nobody can find it.
    void forget_its_file() { std::filesystem::remove(file("other.toml")); }
    std::string label() { return part<QLabel>("profile_label").text().toStdString(); }
    bool comes_to_be_called(const std::string& text) {
        return comes_true([&] { return label() == text; });
    }
    std::string unit() { return session::axis_readout(machine_view(), Axis::r1).unit; }
};

TEST_F(OtherProfile, IsCountedByTheJobsThatTheCoreHasAccepted) {
    Profile own;
    own.tick.missed_alarm_per_s += 1;  // nothing that moves
    std::swap(own.port.pins[index_of(Signal::r1_step)], own.port.pins[index_of(Signal::r2_step)]);
    start_core_with(own);
    forget_its_file();
    open_window();
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    ASSERT_TRUE(comes_to_be_called("profile unknown")) << label();
    EXPECT_EQ(unit(), "pulses");
    publish_job(two_process::long_job());
    ASSERT_TRUE(comes_to_be_called("profile as the job's")) << label();
    EXPECT_EQ(unit(), "mm");
    EXPECT_TRUE(machine_view().is_profile_of_job);
    EXPECT_EQ(machine_view().profile->head_clearance_mm, Profile{}.head_clearance_mm);
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    ASSERT_TRUE(comes_true([&] { return !machine_view().is_heard(); }));
    EXPECT_EQ(unit(), "mm") << "as they were known last";
}

TEST_F(OtherProfile, IsNotTakenFromAJobThatTheCoreRefuses) {
    Profile own;
    own.r1.pulses_per_mm *= 2.0;
    start_core_with(own);
    forget_its_file();
    open_window();
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    ASSERT_TRUE(comes_to_be_called("profile unknown"));
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(two_process::long_job());
    ASSERT_TRUE(save_snapshot(snapshot, file("refused.job")));
    window_->open(QString::fromStdString(file("refused.job")));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    window_->context().open_job.publish();
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("refused"); }))
        << all_messages().toStdString();
    EXPECT_EQ(label(), "profile unknown");
    EXPECT_EQ(unit(), "pulses");
}

TEST_F(OtherProfile, IsFoundInTheFileThatTheCoreWasStartedWith) {
    Profile own;
    own.name = "lathe";
    own.r1.pulses_per_mm *= 2.0;
    start_core_with(own);
    open_window();
    ASSERT_TRUE(comes_to_be_called("profile lathe")) << label();
    EXPECT_EQ(unit(), "mm");
    EXPECT_FALSE(machine_view().is_profile_of_job);
    EXPECT_FALSE(part<QWidget>("core_profile").isVisible()) << "nobody has given another one";
}

TEST_F(OtherProfile, IsToldThoughNobodyFindsItsFile) {
    Profile own;
    own.r1.pulses_per_mm *= 2.0;
    Profile given;
    given.name = "mill_with_a_name_that_takes_more_than_a_third_of_the_row_below_the_pages";
    given.r2.pulses_per_mm *= 2.0;
    start_core_with(own);
    forget_its_file();
    open_window();
    window_->context().machine.set_profile(given);
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("core_profile").isVisible(); }));
    const QString title = part<QLabel>("core_profile_title").text().remove(QChar{0x200B});
    EXPECT_TRUE(title.startsWith("The core runs with another profile than mill_with")) << title.toStdString();
    EXPECT_TRUE(title.endsWith("; its file was not found.")) << title.toStdString();
    EXPECT_FALSE(button("core_profile_take").isVisible());
    EXPECT_FALSE(part<QWidget>("core_profile_details").isVisible());
    EXPECT_EQ(label(), "profile unknown") << "the bar says the rest";
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    ASSERT_TRUE(comes_true([&] { return !part<QWidget>("core_profile").isVisible(); }));
    EXPECT_NE(label(), "profile unknown") << "nothing else says it now";
    EXPECT_TRUE(part<QLabel>("profile_label").toolTip().endsWith("_below_the_pages of --profile"));
}

TEST_F(OtherProfile, IsNotTakenOverByARemedyThatHasNothingToTake) {
    Profile own;
    own.name = "lathe";
    own.r1.pulses_per_mm *= 2.0;
    open_window();
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    start_core_with(own);
    ASSERT_TRUE(comes_to_be_called("profile lathe")) << label();
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("desk_refusal").isVisible(); }));
    ASSERT_TRUE(click("remedy_profile"));
    ASSERT_TRUE(comes_true([&] {
        const auto job = window_->context().open_job.job();
        return job && job->profile.r1 == own.r1;
    }));
    EXPECT_FALSE(window_->context().machine.options().profile) << "nobody has given one";
    EXPECT_FALSE(all_messages().contains("Taken over from the core"));
}

TEST_F(OtherProfile, HasANameThatIsShownAsItIsWrittenWhateverItLooksLike) {
    Profile given;
    given.name = "<b>mill<u>";
    given.tool.diameter_mm += 1.0;
    start_core();
    open_window();
    window_->context().machine.set_profile(given);
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("core_profile").isVisible(); }));
    for (const char* name : {"core_profile_title", "core_profile_details", "profile_label"}) {
        const auto& label = part<QLabel>(name);
        EXPECT_EQ(label.textFormat(), Qt::PlainText) << name;
        EXPECT_FALSE(Qt::mightBeRichText(label.toolTip()) && label.toolTip().contains("<b>")) << name;
    }
    EXPECT_TRUE(part<QLabel>("core_profile_title").text().remove(QChar{0x200B}).contains("<b>mill<u>"));
}

TEST_F(OtherProfile, IsTakenOverAndTheJobSlicedAgainByIt) {
    Profile given;
    given.name = "mill";
    given.r1.pulses_per_mm *= 2.0;
    open_window();
    window_->context().machine.set_profile(given);
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    start_core();
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("core_profile").isVisible(); }));
    const QString title = part<QLabel>("core_profile_title").text().remove(QChar{0x200B});
    EXPECT_EQ(title, "The core runs with profile default, not with mill of --profile");
    const QString details = part<QLabel>("core_profile_details").text().remove(QChar{0x200B});
    EXPECT_TRUE(details.contains("axis.r1.pulses_per_mm: core 400.0, here 800.0")) << details.toStdString();
    take_picture("other_profile_light");
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("desk_refusal").isVisible(); }));
    EXPECT_EQ(part<QLabel>("desk_refusal_title").text(), "Not published");
    EXPECT_TRUE(part<QLabel>("desk_refusal_why").text().contains("another machine"));
    window_->set_theme(ThemeChoice::dark);
    take_picture("not_published_dark");
    ASSERT_TRUE(click("remedy_profile"));
    ASSERT_TRUE(
        comes_true([&] { return window_->context().open_job.view().state == session::OpenJobState::job; }));
    ASSERT_TRUE(comes_true([&] { return !part<QWidget>("core_profile").isVisible(); }));
    EXPECT_TRUE(comes_to_be_called("profile default")) << label();
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_to(session::OpenJobState::published));
}

TEST_F(OtherProfile, IsTakenOverWithAClick) {
    Profile given;
    given.name = "mill";
    given.tool.diameter_mm += 1.0;
    start_core();
    open_window();
    window_->context().machine.set_profile(given);
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("core_profile").isVisible(); }));
    ASSERT_TRUE(click("core_profile_take"));
    ASSERT_TRUE(comes_true([&] { return !part<QWidget>("core_profile").isVisible(); }));
    ASSERT_TRUE(comes_to_be_called("profile default")) << label();
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    ASSERT_TRUE(comes_true([&] { return !machine_view().is_heard(); }));
    EXPECT_EQ(window_->context().machine.options().profile, Profile{}) << "also without a core";
}

}  // namespace
}  // namespace psicarve::ui
