// SPDX-License-Identifier: GPL-3.0-or-later
// The pages Ports, Real time and Profile.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTabWidget>
#include <QTableWidget>

#include <fstream>

#include "hmi/ui/profile_page.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;

class Pages : public WindowRig {
protected:
    void show_page(const char* name) {
        auto* const tabs = window_->findChild<QTabWidget*>();
        tabs->setCurrentWidget(window_->findChild<QWidget*>(name));
        QApplication::processEvents();
        window_->refresh();
    }
    QString text_of(const char* label) { return window_->findChild<QLabel*>(label)->text(); }
    QTableWidgetItem& pin_item(const QString& signal, int column) {
        auto* const table = window_->findChild<QTableWidget*>("pins");
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->item(row, 1)->text() == signal) return *table->item(row, column);
        }
        ADD_FAILURE() << "no row " << signal.toStdString();
        return *table->item(0, column);
    }
    ProfilePage& profile() {
        return *static_cast<ProfilePage*>(window_->findChild<QWidget*>("profile_page"));
    }
    QLineEdit& field(const char* key) {
        auto* const row = window_->findChild<QWidget*>(QString{"row_"} + key);
        EXPECT_NE(row, nullptr) << key;
        return *row->findChild<QLineEdit*>();
    }
    void edit(const char* key, const QString& text) {
        QLineEdit& line = field(key);
        line.setText(text);
        Q_EMIT line.textEdited(text);
    }
    void choose_group(int row) { window_->findChild<QListWidget*>("profile_groups")->setCurrentRow(row); }
};

constexpr int kLevelColumn = 4;
constexpr int kAxisR1 = 2;  // group

TEST_F(Pages, PortsListEveryPinAndShowItsLevel) {
    start_core();
    open_window();
    show_page("ports_page");
    EXPECT_EQ(window_->findChild<QTableWidget*>("pins")->rowCount(), static_cast<int>(kSignalCount));
    EXPECT_EQ(pin_item("R1 step", 0).text(), "5");
    EXPECT_EQ(pin_item("Emergency stop", kLevelColumn).text(), "no pin");
    ASSERT_TRUE(comes_true([&] { return !pin_item("Spindle", kLevelColumn).text().isEmpty(); }));
    EXPECT_TRUE(pin_item("Spindle", kLevelColumn).text().contains("low"));
    take_picture("ports_light");
}

TEST_F(Pages, RealTimeCountsTheCoresTicks) {
    start_core();
    open_window();
    show_page("realtime_page");
    ASSERT_TRUE(
        comes_true([&] { return text_of("realtime_ticks") != "0" && !text_of("realtime_ticks").isEmpty(); }));
    EXPECT_FALSE(text_of("realtime_verdict").isEmpty());
    EXPECT_FALSE(text_of("realtime_percentiles").isEmpty());
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
    ASSERT_TRUE(profile().open(QString::fromStdString(path)));
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
    ASSERT_TRUE(click("profile_save"));
    EXPECT_EQ(load_profile(path)->r1.speed_mm_s, 9.0);
    EXPECT_EQ(load_profile(path + ".bak")->r1.speed_mm_s, 8.0);
    EXPECT_TRUE(all_messages().contains("Profile saved"));
    ASSERT_TRUE(click("profile_restore"));
    EXPECT_EQ(field("axis.r1.speed_mm_s").text(), "8.0");
    ASSERT_TRUE(click("profile_undo"));
    EXPECT_EQ(field("axis.r1.speed_mm_s").text(), "9.0");
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
    EXPECT_FALSE(profile().open("/no/such/machine.toml"));
    EXPECT_TRUE(all_messages().contains("/no/such/machine.toml"));
}

}  // namespace
}  // namespace psicarve::ui
