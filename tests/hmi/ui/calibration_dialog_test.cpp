// SPDX-License-Identifier: GPL-3.0-or-later
// The heads are calibrated in the window, as `psicarve calibrate` does it.
#include <gtest/gtest.h>

#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>

#include "hmi/ui/profile_page.hpp"
#include "shared/base/units.hpp"
#include "shared/profile/profile_text.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

class Calibration : public WindowRig {
protected:
    void write_profile() {
        QFile out{QString::fromStdString(file("machine.toml"))};
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(profile_to_toml(Profile{}).c_str());
    }
    void open_with_profile() {
        ASSERT_NO_FATAL_FAILURE(write_profile());
        open_window();
        static_cast<ProfilePage&>(part<QWidget>("profile_page"))
            .open(QString::fromStdString(file("machine.toml")));
        ASSERT_TRUE(comes_true([&] { return button("profile_calibrate").isEnabled(); }));
        window_->findChild<QAction*>("calibrate_action")->trigger();
        EXPECT_FALSE(part<QDialog>("calibration_dialog").isVisible()) << "its file is read by somebody else";
        EXPECT_EQ(button("profile_save_as").toolTip(), "The profile is being opened");
        ASSERT_TRUE(comes_true([&] { return part<QDialog>("calibration_dialog").isVisible(); }));
    }
    QString text(const char* name) { return part<QLabel>(name).text(); }
    void type(const char* field, const char* what) { part<QLineEdit>(field).setText(what); }
    Profile on_file() {
        const auto profile = load_profile(file("machine.toml"));
        EXPECT_TRUE(profile);
        return profile ? *profile : Profile{};
    }
    void save_picture(const char* name) {
        QApplication::processEvents();
        test::keep_picture(part<QDialog>("calibration_dialog"), name);
    }
};

TEST_F(Calibration, AsksStepByStepAndWritesTheProfileWithABackup) {
    ASSERT_NO_FATAL_FAILURE(write_profile());
    start_core({"--profile", file("machine.toml")});
    open_with_profile();
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    EXPECT_EQ(text("calibration_title"), "1 of 6: Touch-off of R1");
    ASSERT_TRUE(comes_true([&] {
        return text("calibration_reason") ==
               "Here: the machine is off; home it, jog R1 to the pin, and let it rest";
    })) << text("calibration_reason").toStdString();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    Command move{};
    move.kind = CommandKind::move;
    move.axis = 1U << index_of(Axis::r1);
    move.target[index_of(Axis::r1)] = 12.5;
    window_->context().machine.order(move, session::phrase("Go to"));
    ASSERT_TRUE(comes_true([&] {
        return machine_view().state() == S::ready &&
               machine_view().status->position_pulses[index_of(Axis::r1)] == 5000;
    })) << all_messages().toStdString();
    ASSERT_TRUE(click("calibrate_0_here"));
    EXPECT_EQ(part<QLineEdit>("calibrate_0_counted").text(), "12.50000");
    EXPECT_EQ(text("calibrate_0_outcome"), "the diameter of the pin is needed");
    type("calibrate_0_diameter", "25.4");
    EXPECT_EQ(text("calibrate_0_outcome"), "axis.r1.tip_offset_mm: 0.0 → 0.20000");
    save_picture("calibration_touch_off_light");
    EXPECT_FALSE(button("calibrate_back").isEnabled());
    ASSERT_TRUE(click("calibrate_next"));
    ASSERT_TRUE(click("calibrate_1_here"));
    EXPECT_FALSE(part<QLineEdit>("calibrate_1_counted").text().isEmpty());
    type("calibrate_1_counted", "");
    ASSERT_TRUE(click("calibrate_next"));
    EXPECT_EQ(text("calibration_title"), "3 of 6: Two marks");
    type("calibrate_2_diameter", "40");
    type("calibrate_2_around", "0");
    type("calibrate_2_up", "0.2");
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(click("calibrate_next"));
    type("calibrate_4_wear", "0,04");
    ASSERT_TRUE(click("calibrate_back"));
    EXPECT_EQ(text("calibration_title"), "4 of 6: Wear of the tool of R1");
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(click("calibrate_next"));
    EXPECT_FALSE(button("calibrate_next").isVisible());
    auto& changes = part<QTableWidget>("calibration_changes");
    ASSERT_EQ(changes.rowCount(), 3);
    EXPECT_EQ(changes.item(0, 0)->text(), "axis.r1.tip_offset_mm");
    EXPECT_EQ(changes.item(0, 1)->text(), "0.0");
    EXPECT_EQ(changes.item(0, 2)->text(), "0.20000");
    save_picture("calibration_changes_light");
    for (const char* name : {"calibrate_close", "calibrate_back", "calibrate_write"}) {
        EXPECT_EQ(button(name).height(), button("calibrate_back").height()) << name;
        EXPECT_GT(button(name).width(),
                  button(name).fontMetrics().horizontalAdvance(button(name).text()) + 16)
            << name;
    }
    ASSERT_TRUE(click("calibrate_write"));
    EXPECT_TRUE(part<QDialog>("calibration_dialog").isVisible()) << "it is written by somebody else";
    EXPECT_EQ(text("calibration_reason"), "The profile is being saved");
    for (const char* name : {"calibrate_back", "calibrate_write", "calibrate_0_here"})
        EXPECT_EQ(button(name).toolTip(), "The profile is being saved") << name;
    EXPECT_FALSE(part<QLineEdit>("calibrate_0_counted").isEnabled());
    ASSERT_TRUE(comes_true([&] { return !part<QDialog>("calibration_dialog").isVisible(); }));
    EXPECT_DOUBLE_EQ(on_file().r1.tip_offset_mm, 0.2);
    EXPECT_DOUBLE_EQ(on_file().head_r2_height_error_mm, 0.2);
    EXPECT_DOUBLE_EQ(on_file().r2.tool_wear_mm, 0.04);
    const auto backup = load_profile(file("machine.toml.bak"));
    ASSERT_TRUE(backup);
    EXPECT_EQ(profile_hash(*backup), profile_hash(Profile{}));
    EXPECT_TRUE(all_messages().contains("Calibration written: ")) << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return button("profile_calibrate").isEnabled(); }));
    window_->findChild<QAction*>("calibrate_action")->trigger();
    ASSERT_TRUE(comes_true([&] { return part<QDialog>("calibration_dialog").isVisible(); }));
    EXPECT_EQ(part<QLineEdit>("calibrate_4_wear").text(), "") << "it begins anew";
    ASSERT_TRUE(comes_true([&] {
        return button("calibrate_0_here").toolTip().contains("another profile than");
    })) << "the core still counts by the old one";
}

TEST_F(Calibration, LeavesWhatIsTypedIntoThePageMeanwhile) {
    open_with_profile();
    auto& line = *part<QWidget>("row_core_radius_mm").findChild<QLineEdit*>();
    line.setText("1.7");
    Q_EMIT line.textEdited("1.7");
    type("calibrate_3_wear", "0.04");
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(click("calibrate_next"));
    ASSERT_TRUE(click("calibrate_write"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Calibration written: "); }));
    EXPECT_TRUE(comes_true([&] { return button("profile_open").isEnabled(); }));
    EXPECT_EQ(part<QWidget>("row_core_radius_mm").findChild<QLineEdit*>()->text(), "1.7");
    EXPECT_DOUBLE_EQ(on_file().r1.tool_wear_mm, 0.04);
    ASSERT_TRUE(click_and_answer("profile_save", "differences_accept"));
    EXPECT_TRUE(comes_true([&] { return all_messages().contains("Profile saved: "); }))
        << all_messages().toStdString();
    EXPECT_DOUBLE_EQ(on_file().r1.tool_wear_mm, 0.04);
    EXPECT_DOUBLE_EQ(on_file().core_radius_mm, 1.7);
}

// Two who write one file at a time would each lose what the other has written.
TEST_F(Calibration, DoesNotWriteWhileThePageSaves) {
    open_with_profile();
    auto& line = *part<QWidget>("row_core_radius_mm").findChild<QLineEdit*>();
    line.setText("1.7");
    Q_EMIT line.textEdited("1.7");
    type("calibrate_3_wear", "0.04");
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(click("calibrate_next"));
    ASSERT_TRUE(comes_true([&] { return button("calibrate_write").isEnabled(); }));
    ASSERT_TRUE(click_and_answer("profile_save", "differences_accept"));
    button("calibrate_write").click();
    EXPECT_EQ(text("calibration_reason"), "The profile is being saved");
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Profile saved"); }));
    EXPECT_FALSE(all_messages().contains("Calibration written")) << all_messages().toStdString();
    EXPECT_EQ(on_file().core_radius_mm, 1.7);
    EXPECT_EQ(on_file().r1.tool_wear_mm, 0.0);
    // What it has read is old by now, which is refused and said; what was typed stays.
    ASSERT_TRUE(comes_true([&] { return button("calibrate_write").isEnabled(); }));
    ASSERT_TRUE(click("calibrate_write"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Profile not saved"); }));
    EXPECT_EQ(on_file().core_radius_mm, 1.7);
    EXPECT_TRUE(part<QDialog>("calibration_dialog").isVisible());
    EXPECT_EQ(part<QLineEdit>("calibrate_3_wear").text(), "0.04");
}

TEST_F(Calibration, WritesNothingThatCannotBeAndNothingAtAllWhenItIsClosed) {
    open_with_profile();
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(click("calibrate_next"));
    EXPECT_TRUE(comes_true([&] { return text("calibration_reason") == "Write: nothing was measured"; }));
    EXPECT_FALSE(button("calibrate_write").isEnabled());
    type("calibrate_3_wear", "7");
    type("calibrate_4_wear", "0.1");
    EXPECT_TRUE(comes_true([&] { return text("calibration_reason") == "Write: step 4 cannot be"; }));
    EXPECT_FALSE(button("calibrate_write").isEnabled());
    type("calibrate_3_wear", "");
    EXPECT_TRUE(comes_true([&] { return button("calibrate_write").isEnabled(); }));
    ASSERT_TRUE(click("calibrate_close"));
    EXPECT_EQ(profile_hash(on_file()), profile_hash(Profile{}));
    EXPECT_FALSE(QFile::exists(QString::fromStdString(file("machine.toml.bak"))));
}

TEST_F(Calibration, NeedsAProfileFromAFileWithNothingUnsaved) {
    open_window();
    EXPECT_TRUE(comes_true([&] {
        return button("profile_calibrate").toolTip() ==
               "Calibrate: open the machine's profile first, or save this one as a file";
    }));
    EXPECT_FALSE(button("profile_calibrate").isEnabled());
    window_->findChild<QAction*>("calibrate_action")->trigger();
    EXPECT_EQ(window_->findChild<QDialog*>("calibration_dialog"), nullptr);
    EXPECT_TRUE(all_messages().contains("Calibrate: open the machine's profile first"));
}

}  // namespace
}  // namespace psicarve::ui
