// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line names comes into a window that is there already.
#include <gtest/gtest.h>

#include <QLabel>
#include <QMenu>

#include <filesystem>
#include <fstream>

#include "tests/hmi/ui/pages_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

class WindowBegins : public test::PagesRig {
protected:
    WindowBegins() { std::ofstream{profile_} << "name = \"workshop\"\n[axis.r1]\nspeed_mm_s = 8\n"; }
    void begin_with(const std::string& profile, const std::string& path) {
        open_window();
        window_->begin_with(QString::fromStdString(profile), QString::fromStdString(path));
    }

    const std::string profile_ = file("machine.toml");
    const std::string model_ = example("small.stl");
};

TEST_F(WindowBegins, BeforeItsProfileIsReadAndOpensItsFileAfter) {
    begin_with(profile_, model_);
    EXPECT_TRUE(window_->isVisible());
    EXPECT_FALSE(window_->context().machine.options().profile) << "somebody else reads it";
    EXPECT_EQ(window_->context().open_job.view().state, session::OpenJobState::empty);
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    ASSERT_TRUE(window_->context().machine.options().profile);
    EXPECT_EQ(window_->context().machine_profile().name, "workshop");
    ASSERT_TRUE(comes_true([&] { return profile().draft().path() == profile_; }));
}

TEST_F(WindowBegins, AndRefusesFilesUntilTheMachineIsKnown) {
    begin_with(profile_, {});
    window_->open(QString::fromStdString(model_));
    EXPECT_TRUE(all_messages().contains("Open: the machine's profile is still being read"));
    ASSERT_TRUE(comes_true([&] { return window_->context().machine.options().profile.has_value(); }));
    window_->open(QString::fromStdString(model_));
    EXPECT_TRUE(comes_to(session::OpenJobState::model));
}

TEST_F(WindowBegins, AndSaysWhyAProfileIsNotTakenAndOpensNothingForAnotherMachine) {
    begin_with(file("gone.toml"), model_);
    auto& title = part<QLabel>("refusal_title");
    ASSERT_TRUE(comes_true([&] { return title.isVisible(); }));
    EXPECT_EQ(title.text().remove(QChar{0x200B}).toStdString(), "gone.toml was not opened");
    EXPECT_TRUE(all_messages().contains("Not opened, as the machine's profile was not"))
        << all_messages().toStdString();
    EXPECT_EQ(window_->context().open_job.view().state, session::OpenJobState::empty);
}

TEST_F(WindowBegins, WithTheMachinesMillimetresOnceItsProfileIsThere) {
    start_core({"--profile", profile_});
    begin_with(profile_, {});
    ASSERT_TRUE(comes_true([&] {
        return machine_view().profile && machine_view().profile->name == "workshop";
    })) << all_messages().toStdString();
    EXPECT_EQ(machine_view().unused_profile, "");
}

}  // namespace
}  // namespace psicarve::ui
