// SPDX-License-Identifier: GPL-3.0-or-later
// Page Profile waits for no file: it says what is under way, and locks what would get in the way of it.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QTableWidget>
#include <QTimer>

#include <algorithm>
#include <fstream>

#include "tests/hmi/ui/pages_rig.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::ui {
namespace {

constexpr int kGroupOfR1 = 2;
constexpr const char* kSpeed = "axis.r1.speed_mm_s";

class ProfileFiles : public test::PagesRig {
protected:
    ProfileFiles() { std::ofstream(path_) << "[axis.r1]\nspeed_mm_s = 8 # worn\n"; }
    void open_page() {
        open_window();
        show_page("profile_page");
        choose_group(kGroupOfR1);
    }
    void open_file() {
        ASSERT_NO_FATAL_FAILURE(open_page());
        ASSERT_TRUE(opens(path_));
    }
    /// Nothing of it is delivered before the window's next look.
    void expect_locked(const char* why) {
        EXPECT_EQ(text_of("profile_reason").toStdString(), why);
        for (const char* name : {"profile_open", "profile_undo", "profile_restore", "profile_save_as",
                                 "profile_save", "profile_calibrate"}) {
            EXPECT_FALSE(button(name).isEnabled()) << name;
            EXPECT_EQ(button(name).toolTip().toStdString(), why) << name;
            EXPECT_EQ(button(name).accessibleDescription().toStdString(), why) << name;
        }
    }

    const psicarve::test::TemporaryFolder folder_;
    const std::string path_ = folder_.path("machine.toml");
};

TEST_F(ProfileFiles, AreOpenedBySomebodyElse) {
    ASSERT_NO_FATAL_FAILURE(open_page());
    profile().open(QString::fromStdString(path_));
    EXPECT_EQ(profile().draft().path(), "");
    expect_locked("The profile is being opened");
    EXPECT_FALSE(field(kSpeed).isEnabled()) << "what is typed now would be lost";
    ASSERT_TRUE(comes_true([&] { return profile().draft().path() == path_; }));
    EXPECT_EQ(field(kSpeed).text(), "8.0");
    EXPECT_TRUE(field(kSpeed).isEnabled());
    EXPECT_TRUE(button("profile_calibrate").isEnabled());
}

TEST_F(ProfileFiles, SayWhichValuesWaitForTheCoreToBeStartedAnew) {
    start_core();
    ASSERT_NO_FATAL_FAILURE(open_file());
    const auto mark = [&](const char* key) -> const QLabel& {
        return *part<QWidget>((std::string{"row_"} + key).c_str()).findChild<QLabel*>("mark");
    };
    ASSERT_TRUE(comes_true([&] { return mark(kSpeed).text() == "↻"; }));
    EXPECT_EQ(mark(kSpeed).toolTip(), "Needs restart: the core has 10.0 until it is started anew");
    EXPECT_EQ(mark("axis.r1.accel_mm_s2").text(), "") << "the core has that one";
    EXPECT_TRUE(text_of("profile_reason").endsWith("Values that need a restart (↻): 1."))
        << text_of("profile_reason").toStdString();
    take_picture("profile_needs_restart_light");
    edit("axis.r1.accel_mm_s2", "50");
    EXPECT_EQ(mark("axis.r1.accel_mm_s2").text(), "●");
    EXPECT_EQ(mark("axis.r1.accel_mm_s2").toolTip(),
              "In the file: 100.0\nNeeds restart: the core has 100.0 until it is started anew");
    EXPECT_TRUE(text_of("profile_reason").endsWith("Values that need a restart (↻): 1."))
        << "those that are marked so: " << text_of("profile_reason").toStdString();
    edit("axis.r1.accel_mm_s2", "100");
    EXPECT_EQ(mark("axis.r1.accel_mm_s2").text(), "");
    edit(kSpeed, "9");
    EXPECT_FALSE(text_of("profile_reason").contains("↻")) << text_of("profile_reason").toStdString();
    edit(kSpeed, "8");
    EXPECT_TRUE(text_of("profile_reason").contains("↻"));
    core_.reset();
    EXPECT_TRUE(comes_true([&] { return mark(kSpeed).text().isEmpty(); })) << "nobody has another value";
    EXPECT_FALSE(text_of("profile_reason").contains("↻"));
}

TEST_F(ProfileFiles, AreSavedBySomebodyElseWhileOneTypesOn) {
    ASSERT_NO_FATAL_FAILURE(open_file());
    edit(kSpeed, "9");
    profile().save();
    EXPECT_EQ(profile().draft().changed_count(), 1U) << "it is not known to be saved";
    expect_locked("The profile is being saved");
    EXPECT_TRUE(field(kSpeed).isEnabled());
    edit(kSpeed, "10");
    edit("axis.r1.backlash_mm", "0.02");
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Profile saved"); }));
    EXPECT_EQ(load_profile(path_)->r1.speed_mm_s, 9.0);
    EXPECT_EQ(load_profile(path_)->r1.backlash_mm, 0.0);
    EXPECT_EQ(field(kSpeed).text(), "10") << "what was typed since is not lost";
    EXPECT_EQ(profile().draft().changed_count(), 2U);
    ASSERT_TRUE(click_and_answer("profile_save", "differences_accept"));
    ASSERT_TRUE(comes_true([&] { return profile().draft().changed_count() == 0; }))
        << all_messages().toStdString();
    EXPECT_EQ(load_profile(path_)->r1.speed_mm_s, 10.0);
}

TEST_F(ProfileFiles, GetAnotherNameFromSomebodyElse) {
    ASSERT_NO_FATAL_FAILURE(open_file());
    profile().save_as(QString::fromStdString(folder_.path("other.toml")));
    EXPECT_EQ(profile().draft().path(), path_);
    expect_locked("The profile is being saved");
    ASSERT_TRUE(comes_true([&] { return profile().draft().path() == folder_.path("other.toml"); }));
    EXPECT_TRUE(entries_of("profile_open_menu").contains("other.toml"));
}

TEST_F(ProfileFiles, ThatCannotBeSavedLeaveWhatWasTyped) {
    ASSERT_NO_FATAL_FAILURE(open_file());
    edit(kSpeed, "9");
    std::ofstream(path_) << "name = \"another\"\n";
    ASSERT_TRUE(click_and_answer("profile_save", "differences_accept"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Profile not saved"); }));
    EXPECT_EQ(field(kSpeed).text(), "9");
    EXPECT_EQ(profile().draft().changed_count(), 1U);
    EXPECT_TRUE(comes_true([&] { return button("profile_save").isEnabled(); }));
}

TEST_F(ProfileFiles, ThatAreBeingSavedAreAskedAboutWhenTheWindowCloses) {
    ASSERT_NO_FATAL_FAILURE(open_page());
    profile().save_as(QString::fromStdString(path_));
    ASSERT_EQ(profile().draft().changed_count(), 0U);
    QString question;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, window_.get(), [&] {
        auto* const box = window_->findChild<QMessageBox*>();
        if (box == nullptr || !box->isVisible()) return;
        question = box->text();
        box->button(QMessageBox::Cancel)->click();
    });
    look.start(0);
    EXPECT_FALSE(window_->close());
    look.stop();
    EXPECT_EQ(question, "The profile is still being saved. Lose what is not saved yet?");
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Profile saved"); }));
    EXPECT_TRUE(window_->close());
}

// A dialog that asks for a name or another file does not keep anyone from the page.
TEST_F(ProfileFiles, AreReadAndWrittenOneAfterTheOther) {
    ASSERT_NO_FATAL_FAILURE(open_file());
    std::ofstream(folder_.path("other.toml")) << "[axis.r1]\nspeed_mm_s = 5\n";
    edit(kSpeed, "9");
    profile().save();
    profile().open(QString::fromStdString(folder_.path("other.toml")));
    profile().save_as(QString::fromStdString(folder_.path("third.toml")));
    EXPECT_EQ(all_messages().count("The profile is being saved"), 2) << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return profile().draft().changed_count() == 0; }));
    EXPECT_EQ(profile().draft().path(), path_) << "and nothing waits";
    EXPECT_EQ(load_profile(path_)->r1.speed_mm_s, 9.0);
    EXPECT_EQ(load_profile(folder_.path("other.toml"))->r1.speed_mm_s, 5.0);
    EXPECT_FALSE(QFile::exists(QString::fromStdString(folder_.path("third.toml"))));
    profile().open(QString::fromStdString(folder_.path("other.toml")));
    profile().open(QString::fromStdString(path_));
    ASSERT_TRUE(comes_true([&] { return profile().draft().path() == folder_.path("other.toml"); }));
    EXPECT_EQ(field(kSpeed).text(), "5.0");
    EXPECT_EQ(profile().draft().changed_count(), 0U) << "nothing of one file comes into the other";
    EXPECT_TRUE(all_messages().contains("The profile is being opened"));
}

TEST_F(ProfileFiles, BackupsAreReadBySomebodyElse) {
    ASSERT_NO_FATAL_FAILURE(open_file());
    edit(kSpeed, "9");
    ASSERT_TRUE(click_and_answer("profile_save", "differences_accept"));
    ASSERT_TRUE(comes_true([&] { return button("profile_restore").isEnabled(); }));
    ASSERT_TRUE(choose("profile_backups_menu", entries_of("profile_backups_menu").value(0)));
    EXPECT_EQ(field(kSpeed).text(), "9");
    expect_locked("The backup is being read");
    EXPECT_FALSE(field(kSpeed).isEnabled());
    ASSERT_TRUE(comes_true([&] { return field(kSpeed).text() == "8.0"; }));
    EXPECT_EQ(profile().draft().changed_count(), 1U) << "nothing is saved yet";
    EXPECT_TRUE(field(kSpeed).isEnabled());
}

// What is saved is looked at before: each key with what stands in the file and what will.
TEST_F(ProfileFiles, AreSavedOnceTheirChangesWereLookedAt) {
    ASSERT_NO_FATAL_FAILURE(open_file());
    edit(kSpeed, "9");
    auto* const home = window_->findChild<QWidget*>("row_axis.r1.home")->findChild<QComboBox*>();
    home->setCurrentText("none");
    QStringList told;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, window_.get(), [&] {
        auto* const table = window_->findChild<QTableWidget*>("differences_table");
        if (table == nullptr || !table->isVisible()) return;
        told += part<QLabel>("differences_said").text();
        for (int row = 0; row < table->rowCount(); ++row) {
            for (int column = 0; column < table->columnCount(); ++column)
                told += table->item(row, column)->text();
        }
        look.stop();
    });
    look.start(0);
    ASSERT_TRUE(click_and_answer("profile_save", "differences_cancel"));
    EXPECT_EQ(told, (QStringList{"machine.toml: 2 values become others", kSpeed, "8.0 mm/s", "9 mm/s",
                                 "axis.r1.home", "\"max\"", "\"none\""}));
    EXPECT_EQ(load_profile(path_)->r1.speed_mm_s, 8.0) << "nothing was saved";
    EXPECT_EQ(profile().draft().changed_count(), 2U) << "and nothing is lost";
    ASSERT_TRUE(click_and_answer("profile_save", "differences_accept"));
    ASSERT_TRUE(comes_true([&] { return profile().draft().changed_count() == 0; }));
    EXPECT_EQ(load_profile(path_)->r1.speed_mm_s, 9.0);
}

// The page stays open to whoever types on meanwhile.
TEST_F(ProfileFiles, AreNotSavedWithWhatWasNotLookedAt) {
    ASSERT_NO_FATAL_FAILURE(open_file());
    edit(kSpeed, "9");
    QStringList said;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, window_.get(), [&] {
        for (auto* const table : window_->findChildren<QTableWidget*>("differences_table")) {
            if (!table->isVisible()) continue;
            QWidget& question = *table->window();
            said += question.findChild<QLabel*>("differences_said")->text();
            if (said.size() == 1) edit("axis.r1.backlash_mm", "0.02");
            if (said.size() == 2) {
                EXPECT_EQ(table->item(1, 0)->text(), "axis.r1.backlash_mm");
                EXPECT_EQ(load_profile(path_)->r1.backlash_mm, 0.0);
            }
            return question.findChild<QAbstractButton*>("differences_accept")->click();
        }
    });
    look.start(0);
    button("profile_save").click();
    look.stop();
    EXPECT_EQ(said, (QStringList{"machine.toml: one value becomes another",
                                 "machine.toml: 2 values become others"}));
    ASSERT_TRUE(comes_true([&] { return profile().draft().changed_count() == 0; }))
        << all_messages().toStdString();
    EXPECT_EQ(load_profile(path_)->r1.backlash_mm, 0.02);
}

TEST_F(ProfileFiles, ShowOnlyWhatIsNotSavedWhereThatIsAskedFor) {
    const auto shown = [this](const char* key) {
        return window_->findChild<QWidget*>(QString{"row_"} + key) != nullptr;
    };
    ASSERT_NO_FATAL_FAILURE(open_file());
    EXPECT_TRUE(shown("axis.r1.accel_mm_s2"));
    ASSERT_TRUE(click("profile_only_changed"));
    EXPECT_FALSE(shown(kSpeed)) << "it differs from the default, not from the file";
    EXPECT_EQ(text_of("profile_no_rows"), "Nothing was changed");
    ASSERT_TRUE(click("profile_only_changed"));
    edit(kSpeed, "9");
    choose_group(0);
    edit("core_radius_mm", "1.7");
    ASSERT_TRUE(click("profile_only_changed"));
    EXPECT_TRUE(shown(kSpeed));
    EXPECT_TRUE(shown("core_radius_mm")) << "of whatever part";
    EXPECT_FALSE(shown("axis.r1.accel_mm_s2"));
    take_picture("profile_changed_light");
    edit(kSpeed, "8.0");
    EXPECT_TRUE(shown(kSpeed)) << "a row does not go while somebody types into it";
    ASSERT_TRUE(click_and_answer("profile_save", "differences_accept"));
    ASSERT_TRUE(comes_true([&] { return profile().draft().changed_count() == 0; }));
    EXPECT_FALSE(shown("core_radius_mm"));
    EXPECT_FALSE(shown(kSpeed));
}

class ProfileProblems : public ProfileFiles, public ::testing::WithParamInterface<Language> {
protected:
    ProfileProblems() { use_language(GetParam()); }
    ~ProfileProblems() override { use_language(Language::english); }
};

// The words of this language, and what stands in them is the same in all.
TEST_P(ProfileProblems, AreToldInTheOperatorsLanguage) {
    ASSERT_NO_FATAL_FAILURE(open_file());
    edit(kSpeed, "10001");
    const auto* const row = window_->findChild<QWidget*>(QString{"row_"} + kSpeed);
    const QString told = field(kSpeed).accessibleDescription();
    EXPECT_TRUE(told.contains("10001 mm/s") && told.contains("0.001")) << told.toStdString();
    const auto labels = row->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&told](const QLabel* label) {
        return label->isVisible() && label->text() == told;
    }));
    EXPECT_EQ(told.contains("is impossible; give a value from"), GetParam() == Language::english)
        << told.toStdString();
    std::ofstream(path_) << "[axis.r1]\nspeed_mms = 8\n";
    profile().open(QString::fromStdString(path_));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("axis.r1.speed_mms"); }));
    EXPECT_EQ(all_messages().contains("unknown key"), GetParam() == Language::english)
        << all_messages().toStdString();
}

INSTANTIATE_TEST_SUITE_P(All, ProfileProblems,
                         ::testing::Values(Language::english, Language::chinese, Language::russian));

}  // namespace
}  // namespace psicarve::ui
