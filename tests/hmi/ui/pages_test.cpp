// SPDX-License-Identifier: GPL-3.0-or-later
// The pages Ports, Real time and Profile.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>

#include <filesystem>
#include <fstream>

#include "tests/hmi/ui/pages_rig.hpp"
#include "tests/places.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::ui {
namespace {

using test::PagesRig;

class Pages : public PagesRig {
protected:
    QTableWidgetItem& pin_item(const QString& signal, int column) {
        auto* const table = window_->findChild<QTableWidget*>("pins");
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->item(row, 1)->text() == signal) return *table->item(row, column);
        }
        ADD_FAILURE() << "no row " << signal.toStdString();
        return *table->item(0, column);
    }
};

constexpr int kLevelColumn = 4;
constexpr int kAxisR1 = 2;  // group

TEST_F(Pages, PortsListEveryPinAndShowItsLevel) {
    start_core();
    open_window();
    show_page("ports_page");
    EXPECT_EQ(window_->findChild<QTableWidget*>("pins")->rowCount(),
              static_cast<int>(kSignalCount - kSwitchedOutputCount));
    EXPECT_EQ(pin_item("R1 step", 0).text(), "5");
    EXPECT_EQ(pin_item("Emergency stop", kLevelColumn).text(), "no pin");
    ASSERT_TRUE(comes_true([&] { return !pin_item("Spindle", kLevelColumn).text().isEmpty(); }));
    EXPECT_TRUE(pin_item("Spindle", kLevelColumn).text().contains("low"));
    take_picture("ports_light");
}

TEST_F(Pages, MessagesAreFoundByTheirWords) {
    open_window();
    window_->context().log.add(session::Severity::info, session::phrase("Opened %1", "vase.stl"));
    window_->context().log.add(session::Severity::warning, session::phrase("Not saved: %1", "disk full"));
    show_page("messages_page");
    const QAbstractItemModel& rows = *part<QTableView>("messages").model();
    const auto shown = [&] {
        QStringList texts;
        for (int row = 0; row < rows.rowCount(); ++row) texts += rows.index(row, 3).data().toString();
        return texts;
    };
    EXPECT_GE(shown().size(), 2);
    auto* const find = window_->findChild<QLineEdit*>("messages_find");
    find->setText("DISK");
    EXPECT_EQ(shown(), QStringList{"Not saved: disk full"});
    find->clear();
    EXPECT_GE(shown().size(), 2);
}

TEST_F(Pages, TheTabOfMessagesTellsHowManyAreUnread) {
    open_window();
    const auto* const bar = window_->findChild<QTabWidget*>()->tabBar();
    const auto unread = [&] {
        window_->refresh();
        const auto* const badge = qobject_cast<QLabel*>(bar->tabButton(5, QTabBar::RightSide));
        return badge != nullptr && badge->isVisible() ? badge->text() : QString{};
    };
    EXPECT_EQ(unread(), "");
    for (const char* count : {"1", "2", "3"}) {
        window_->context().log.add(session::Severity::warning, session::phrase("Not saved: %1", "disk full"));
        EXPECT_EQ(unread(), count);
    }
    show_page("messages_page");
    EXPECT_EQ(unread(), "");
}

TEST_F(Pages, TheNumberOnATabHasTheInkOfItsGround) {
    open_window();
    window_->set_theme(ThemeChoice::dark);
    const auto badge_after = [&](session::Severity severity) -> const QLabel& {
        window_->context().log.add(severity, session::phrase("Not saved: %1", "disk full"));
        window_->refresh();
        return part<QLabel>("tab_badge_5");
    };
    const auto ink = [](const QLabel& badge) { return badge.palette().color(QPalette::WindowText).name(); };
    const Tokens& tokens = tokens_of(Theme::dark);
    EXPECT_FALSE(style_sheet(tokens).contains('@')) << "a colour without a name";
    EXPECT_EQ(ink(badge_after(session::Severity::warning)), tokens.on_warn.name());
    EXPECT_EQ(ink(badge_after(session::Severity::alarm)), tokens.on_fill.name());
}

TEST_F(Pages, WhatWasTypedIntoTheProfileIsNotLostWithTheWindow) {
    open_window();
    show_page("profile_page");
    edit("core_radius_mm", "1.7");
    const auto close_and = [this](QMessageBox::StandardButton answer) {
        QTimer::singleShot(0, window_.get(), [this, answer] {
            auto* const box = window_->findChild<QMessageBox*>();
            ASSERT_NE(box, nullptr);
            box->button(answer)->click();
        });
        return window_->close();
    };
    EXPECT_FALSE(close_and(QMessageBox::Cancel));
    EXPECT_EQ(profile().draft().changed_count(), 1U);
    EXPECT_TRUE(close_and(QMessageBox::Discard));
}

TEST_F(Pages, RealTimeCountsTheCoresTicks) {
    start_core();
    open_window();
    show_page("realtime_page");
    ASSERT_TRUE(
        comes_true([&] { return text_of("realtime_ticks") != "0" && !text_of("realtime_ticks").isEmpty(); }));
    EXPECT_FALSE(text_of("realtime_verdict").isEmpty());
    // On the virtual clock there is no lateness to tell of.
    EXPECT_TRUE(text_of("realtime_verdict").contains("virtual clock"));
    for (const char* figure :
         {"realtime_percentiles", "realtime_greatest", "realtime_missed", "realtime_faults"})
        EXPECT_EQ(text_of(figure), "\u2013") << figure;
    EXPECT_EQ(text_of("realtime_rights"), "not needed on the virtual clock");
    take_picture("realtime_light");
}

TEST_F(Pages, RealTimeSaysThatThereIsNoCore) {
    open_window();
    show_page("realtime_page");
    EXPECT_EQ(text_of("realtime_verdict"), "No core has been seen yet");
}

TEST_F(Pages, ProfileChecksAsOneTypesAndSavesWithABackup) {
    const psicarve::test::TemporaryFolder folder;
    const std::string path = folder.path("machine.toml");
    std::ofstream(path) << "[axis.r1]\nspeed_mm_s = 8 # worn\n";
    open_window();
    show_page("profile_page");
    ASSERT_TRUE(opens(path));
    choose_group(kAxisR1);
    EXPECT_EQ(field("axis.r1.speed_mm_s").text(), "8.0");
    EXPECT_FALSE(button("profile_save").isEnabled());
    edit("axis.r1.start_stop_mm_s", "15");
    EXPECT_EQ(profile().problem_count(), 1U);
    EXPECT_FALSE(button("profile_save").isEnabled());
    EXPECT_TRUE(text_of("profile_reason") == "Save: one value is wrong")
        << text_of("profile_reason").toStdString();
    take_picture("profile_invalid_light");
    edit("axis.r1.start_stop_mm_s", "0.8");
    edit("axis.r1.speed_mm_s", "9");
    EXPECT_EQ(profile().problem_count(), 0U);
    ASSERT_TRUE(click_and_answer("profile_save", "differences_accept"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Profile saved"); }));
    EXPECT_EQ(load_profile(path)->r1.speed_mm_s, 9.0);
    EXPECT_EQ(load_profile(path + ".bak")->r1.speed_mm_s, 8.0);
    ASSERT_TRUE(comes_true([&] { return button("profile_restore").isEnabled(); }));
    const QStringList backups = entries_of("profile_backups_menu");
    ASSERT_EQ(backups.size(), 1);
    EXPECT_TRUE(backups[0].endsWith("  machine.toml.bak")) << backups[0].toStdString();
    ASSERT_TRUE(choose("profile_backups_menu", backups[0]));
    EXPECT_TRUE(comes_true([&] { return field("axis.r1.speed_mm_s").text() == "8.0"; }));
    ASSERT_TRUE(click("profile_undo"));
    EXPECT_EQ(field("axis.r1.speed_mm_s").text(), "9.0");
}

TEST_F(Pages, ProfileGroupsTheThousandsOfItsBounds) {
    open_window();
    show_page("profile_page");
    QStringList bounds;
    for (const QLabel* label : window_->findChildren<QLabel*>()) {
        if (label->text().contains(" ... ")) bounds += label->text();
    }
    EXPECT_FALSE(bounds.filter("\u2009").isEmpty());
    for (const QString& text : bounds)
        EXPECT_FALSE(text.contains(QRegularExpression{"(?<![\\d.])\\d{4}"})) << text.toStdString();
}

TEST_F(Pages, ProfilesThatWereOpenedAreOpenedAgain) {
    const psicarve::test::TemporaryFolder folder;
    std::ofstream(folder.path("left.toml")) << "name = \"left\"\n";
    std::ofstream(folder.path("right.toml")) << "name = \"right\"\n";
    open_window();
    show_page("profile_page");
    for (const char* name : {"left.toml", "right.toml", "left.toml"}) ASSERT_TRUE(opens(folder.path(name)));
    EXPECT_EQ(entries_of("profile_open_menu").mid(0, 3),
              (QStringList{"Choose a file...", "left.toml", "right.toml"}));
    ASSERT_TRUE(choose("profile_open_menu", "right.toml"));
    EXPECT_TRUE(comes_true([&] { return profile().draft().path() == folder.path("right.toml"); }));
    ASSERT_TRUE(choose("profile_open_menu", "Built-in profile"));
    EXPECT_EQ(profile().draft().path(), "");
    EXPECT_EQ(profile().draft().changed_count(), 0U);
    std::filesystem::remove(folder.path("left.toml"));
    show_page("ports_page");
    show_page("profile_page");
    EXPECT_TRUE(comes_true([&] { return !entries_of("profile_open_menu").contains("left.toml"); }));
    EXPECT_TRUE(entries_of("profile_open_menu").contains("right.toml"));
    std::ofstream(folder.path("left.toml")) << "name = \"left\"\n";
    show_page("ports_page");
    show_page("profile_page");
    EXPECT_TRUE(comes_true([&] { return entries_of("profile_open_menu").contains("left.toml"); }))
        << "it is not forgotten";
}

TEST_F(Pages, FilesThatWereOpenedAreOfferedWhileTheyAreThere) {
    const psicarve::test::TemporaryFolder folder;
    const QString gone = QString::fromStdString(folder.path("gone.stl"));
    ASSERT_TRUE(QFile::copy(QString::fromStdString(example("small.stl")), gone));
    test::KeptSettings{}.add_recent_file(gone);
    test::KeptSettings{}.add_recent_file(QString::fromStdString(example("small.stl")));
    open_window();
    EXPECT_EQ(entries_of("recent_menu"), (QStringList{"small.stl", "gone.stl"}));
    QFile::remove(gone);
    EXPECT_TRUE(comes_true([&] { return entries_of("recent_menu") == QStringList{"small.stl"}; }));
}

TEST_F(Pages, ProfileFindsKeysAndShowsOnlyWhatDiffers) {
    open_window();
    show_page("profile_page");
    window_->findChild<QLineEdit*>("profile_find")->setText("BACKLASH");
    EXPECT_NE(window_->findChild<QWidget*>("row_axis.psi.backlash_deg"), nullptr);
    EXPECT_EQ(window_->findChild<QWidget*>("row_axis.r1.speed_mm_s"), nullptr);
    edit("axis.psi.backlash_deg", "0,1");
    window_->findChild<QLineEdit*>("profile_find")->clear();
    ASSERT_TRUE(click("profile_compare"));
    EXPECT_NE(window_->findChild<QWidget*>("row_axis.psi.backlash_deg"), nullptr);
    EXPECT_EQ(window_->findChild<QWidget*>("row_axis.y.backlash_mm"), nullptr);
    take_picture("profile_compare_light");
}

TEST_F(Pages, ProfileSaysWhatItCannotOpen) {
    open_window();
    profile().open("/no/such/machine.toml");
    EXPECT_TRUE(comes_true([&] { return all_messages().contains("/no/such/machine.toml"); }));
    EXPECT_EQ(profile().draft().path(), "");
    EXPECT_TRUE(button("profile_open").isEnabled());
}

}  // namespace
}  // namespace psicarve::ui
