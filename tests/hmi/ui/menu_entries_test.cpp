// SPDX-License-Identifier: GPL-3.0-or-later
// The menus' entries, clicked where they stand, each with its effect.
#include <gtest/gtest.h>

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>

#include <fstream>
#include <optional>
#include <utility>

#include "hmi/ui/settings.hpp"
#include "tests/hmi/replay/recorded_run.hpp"
#include "tests/hmi/ui/hands_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;
using S = MachineState;

class MenuEntries : public replay::test::RecordedOn<test::HandsRig> {
protected:
    bool shows(const char* page) {
        auto& tabs = part<QTabWidget>("tabs");
        return tabs.currentWidget()->isAncestorOf(&part<QWidget>(page));
    }
    void open_job(const JobTable& table) {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(snapshot, file("short.job")));
        window_->open(QString::fromStdString(file("short.job")));
        ASSERT_TRUE(comes_to(OpenJobState::job));
    }
    bool is_saved(const std::string& name) {
        return comes_true(
            [&] { return all_messages().contains(QString::fromStdString("Saved: " + file(name))); });
    }
};

TEST_F(MenuEntries, OfFileOpenAndSaveWhatCanBeReadAgain) {
    start_core();
    open_in_front();
    EXPECT_FALSE(entry("save_job").isEnabled());
    EXPECT_FALSE(entry("save_tables").isEnabled());
    const JobTable table = two_process::lobed_job(3, 40);
    ASSERT_NO_FATAL_FAILURE(publish_job(table));
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("save_job")); }, file("kept.psi")));
    ASSERT_TRUE(is_saved("kept.psi")) << all_messages().toStdString();
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("save_tables")); }, file("kept.csv")));
    ASSERT_TRUE(is_saved("kept.csv")) << all_messages().toStdString();
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("save_snapshot")); }, file("kept.snap")));
    ASSERT_TRUE(is_saved("kept.snap")) << all_messages().toStdString();
    const auto job = load_snapshot(file("kept.psi"));
    ASSERT_TRUE(job);
    EXPECT_EQ(job->job_blob, job_blob_from_table(table));
    EXPECT_FALSE(job->status);
    const auto snapshot = load_snapshot(file("kept.snap"));
    ASSERT_TRUE(snapshot);
    EXPECT_TRUE(snapshot->status);
    for (const char* kept : {"kept.psi", "kept.csv"}) {
        EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("open_action")); }, file(kept)));
        ASSERT_TRUE(comes_true([&] {
            return window_->context().open_job.path() == file(kept) &&
                   window_->context().open_job.job() != nullptr &&
                   !window_->context().open_job.view().is_busy();
        })) << all_messages().toStdString();
        EXPECT_EQ(job_blob_from_table(table).size(), job->job_blob.size());
        EXPECT_EQ(window_->context().open_job.job()->view.layer_count(), 3U) << kept;
    }
    Q_EMIT part<QMenu>("recent_menu").aboutToShow();
    EXPECT_TRUE(choose_entry("recent_file"));
    EXPECT_TRUE(comes_true([&] { return !window_->context().open_job.view().is_busy(); }));
    EXPECT_TRUE(choose_entry("close_action"));
    EXPECT_FALSE(window_->isVisible());
}

TEST_F(MenuEntries, OfMachineGoThereTurnTheSpindleAndShowThePorts) {
    start_core();
    open_in_front();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_TRUE(choose_entry("go_to_action"));
    EXPECT_TRUE(comes_true([&] { return part<QDialog>("move_dialog").isVisible(); }));
    ASSERT_TRUE(click("move_close"));
    EXPECT_FALSE(part<QDialog>("move_dialog").isVisible());
    EXPECT_TRUE(choose_entry("spindle_action"));
    EXPECT_TRUE(comes_true([&] { return machine_view().is_active(Signal::spindle); }));
    EXPECT_TRUE(choose_entry("spindle_action"));
    EXPECT_TRUE(comes_true([&] { return !machine_view().is_active(Signal::spindle); }));
    EXPECT_TRUE(choose_entry("wiring_action"));
    EXPECT_TRUE(shows("ports_page"));
}

TEST_F(MenuEntries, OfViewChooseThemeLanguageAndPanels) {
    open_in_front();
    const std::pair<const char*, ThemeChoice> themes[] = {{"theme_dark", ThemeChoice::dark},
                                                          {"theme_light", ThemeChoice::light},
                                                          {"theme_system", ThemeChoice::system}};
    for (const auto& [name, choice] : themes) {
        const QString before = window_->styleSheet();
        EXPECT_TRUE(choose_entry(name));
        EXPECT_EQ(WindowSettings{*window_->context().settings}.theme(), choice);
        EXPECT_EQ(window_->styleSheet() == before, choice == ThemeChoice::system) << name;
    }
    const std::pair<const char*, std::optional<Language>> languages[] = {
        {"language_ru", Language::russian},
        {"language_zh_CN", Language::chinese},
        {"language_en", Language::english},
        {"language_system", std::nullopt}};
    for (const auto& [name, choice] : languages) {
        EXPECT_TRUE(choose_entry(name));
        EXPECT_EQ(WindowSettings{*window_->context().settings}.language(), choice) << name;
        const Language wanted = choice.value_or(desktop_language());
        EXPECT_TRUE(comes_true([&] { return used_language() == wanted; })) << name;
    }
    const std::pair<const char*, const char*> panels[] = {
        {"float_position", "home"}, {"float_jog", "jog_y_up"}, {"float_job", "start"}};
    for (const auto& [name, inside] : panels) {
        EXPECT_TRUE(choose_entry(name));
        EXPECT_TRUE(comes_true([&, inside = inside] { return button(inside).window() != window_.get(); }))
            << name;
    }
    EXPECT_TRUE(choose_entry("float_jog")) << "and back";
    EXPECT_EQ(button("jog_y_up").window(), window_.get());
    EXPECT_TRUE(choose_entry("reset_layout"));
    for (const auto& [name, inside] : panels) EXPECT_EQ(button(inside).window(), window_.get()) << name;
}

TEST_F(MenuEntries, OfToolsVerifyCompareCalibrateAndCheck) {
    record();
    open_in_front();
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("verify_action")); }, whole_trace()));
    ASSERT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("verdict") != nullptr; }))
        << all_messages().toStdString();
    ASSERT_TRUE(click("verdict_close"));
    EXPECT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("verdict") == nullptr; }));
    window_->open(QString::fromStdString(job()));
    ASSERT_TRUE(comes_to(OpenJobState::job));
    EXPECT_TRUE(named_file([&] { EXPECT_TRUE(choose_entry("verify_action")); }, trace()));
    ASSERT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("verdict") != nullptr; }))
        << all_messages().toStdString();
    EXPECT_TRUE(named_file([&] { click("save_picture"); }, file("carved.png")));
    ASSERT_TRUE(is_saved("carved.png")) << all_messages().toStdString();
    const QImage picture{QString::fromStdString(file("carved.png"))};
    EXPECT_GT(picture.width(), 100);
    ASSERT_TRUE(click("verdict_close"));
    EXPECT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("verdict") == nullptr; }));
    EXPECT_TRUE(named_files([&] { EXPECT_TRUE(choose_entry("compare_action")); }, {job(), snapshot()}));
    ASSERT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("differences") != nullptr; }))
        << all_messages().toStdString();
    part<QDialog>("differences").close();
    EXPECT_TRUE(choose_entry("check_computer_action"));
    EXPECT_TRUE(shows("realtime_page"));
    EXPECT_TRUE(comes_true([&] { return part<QTableWidget>("computer_table").rowCount() >= 10; }));
    std::ofstream(file("machine.toml")) << "name = \"lathe\"\n";
    ASSERT_TRUE(opens(file("machine.toml")));
    EXPECT_TRUE(choose_entry("calibrate_action"));
    EXPECT_TRUE(shows("profile_page"));
    EXPECT_TRUE(comes_true([&] { return window_->findChild<QDialog*>("calibration_dialog") != nullptr; }));
}

TEST_F(MenuEntries, OfHelpShowTheKeysAndTheVersion) {
    open_in_front();
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(choose_entry("keys_action")); },
                         {[](QDialog& list) { EXPECT_EQ(list.objectName(), "keys"); }}));
    EXPECT_TRUE(answered([&] { EXPECT_TRUE(choose_entry("about_action")); }, {[](QDialog& about) {
                             EXPECT_TRUE(
                                 static_cast<QMessageBox&>(about).text().contains("GPL-3.0-or-later"));
                             QTest::mouseClick(about.findChild<QPushButton*>("about_ok"), Qt::LeftButton);
                             EXPECT_FALSE(about.isVisible());
                         }}));
}

TEST_F(MenuEntries, LeaveReplayLeavesIt) {
    record();
    open_in_front();
    EXPECT_FALSE(entry("leave_replay").isEnabled());
    window_->open(QString::fromStdString(snapshot()));
    ASSERT_TRUE(comes_true([&] { return window_->context().replay.is_open(); }));
    EXPECT_TRUE(choose_entry("leave_replay"));
    EXPECT_FALSE(window_->context().replay.is_open());
    EXPECT_TRUE(comes_true([&] { return !part<QWidget>("replay_bar").isVisible(); }));
}

}  // namespace
}  // namespace psicarve::ui
