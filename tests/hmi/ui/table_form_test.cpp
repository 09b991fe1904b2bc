// SPDX-License-Identifier: GPL-3.0-or-later
// A table in the window: what of page Model's form applies to it, as on the command line.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "hmi/cam/table_job.hpp"
#include "shared/job/job.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;

class TableForm : public test::WindowRig {
protected:
    std::string table() const {
        std::string path = file("radii.csv");
        std::ofstream out{path};
        out << "y_mm,r_mm\n";
        for (int layer = 0; layer < 8; ++layer) out << 2 + 2 * layer << ",6,7,8,7,6,7,9,7,6\n";
        return path;
    }
    void open_table() {
        window_->open(QString::fromStdString(table()));
        ASSERT_TRUE(comes_to(OpenJobState::job)) << all_messages().toStdString();
    }
    void choose(const char* name, int index) { part<QComboBox>(name).setCurrentIndex(index); }
    void set(const char* name, double value) { part<QDoubleSpinBox>(name).setValue(value); }
    bool says(const char* beginning) {
        return comes_true([&] { return part<QLabel>("desk_state").text().startsWith(beginning); });
    }
    /// The bytes that the command line would have made: slice radii.csv --tool ball:3 --blank 12x20
    /// --stepdown 1.
    std::vector<std::byte> wanted(std::optional<Joining> joining) const {
        Profile profile = window_->context().machine_profile();
        profile.tool.shape = ToolShape::ball;
        profile.tool.diameter_mm = 3.0;
        profile.blank.radius_mm = 12.0;
        profile.blank.height_mm = 20.0;
        profile.roughing.stepdown_mm = 1.0;
        return job_blob_from_table(cam::job_from_table(file("radii.csv"), profile, joining).value().table);
    }
    void choose_tool_blank_and_roughing() {
        choose("tool", part<QComboBox>("tool").findData(static_cast<int>(ToolShape::ball)));
        set("tool_diameter", 3.0);
        set("blank_radius", 12.0);
        set("blank_height", 20.0);
        choose("roughing", 1);
        set("stepdown", 1.0);
    }
    bool has_made(const std::vector<std::byte>& blob) {
        return comes_true([&] {
            const auto job = window_->context().open_job.job();
            return job && std::equal(job->blob.begin(), job->blob.end(), blob.begin(), blob.end());
        });
    }
};

TEST_F(TableForm, MakesTheJobAnewWithToolBlankAndRoughing) {
    open_window();
    ASSERT_NO_FATAL_FAILURE(open_table());
    ASSERT_TRUE(says("The job is ready")) << part<QLabel>("desk_state").text().toStdString();
    EXPECT_TRUE(window_->context().open_job.job()->view.passes().size() < 2);
    choose_tool_blank_and_roughing();
    EXPECT_TRUE(says("Changed since")) << part<QLabel>("desk_state").text().toStdString();
    ASSERT_TRUE(click("slice"));
    EXPECT_TRUE(has_made(wanted(std::nullopt))) << all_messages().toStdString();
    EXPECT_GT(window_->context().open_job.job()->view.passes().size(), 2U);
    EXPECT_TRUE(says("The job is ready")) << part<QLabel>("desk_state").text().toStdString();
    choose("joining", part<QComboBox>("joining").findData("zigzag"));
    EXPECT_TRUE(says("Changed since"));
    ASSERT_TRUE(click("slice"));
    EXPECT_TRUE(has_made(wanted(Joining::zigzag))) << all_messages().toStdString();
    // What cannot be made leaves the job that is there, and says so.
    choose("joining", part<QComboBox>("joining").findData("spiral"));
    ASSERT_TRUE(click("slice"));
    EXPECT_TRUE(comes_true([&] { return all_messages().contains("a table of layers is no spiral"); }))
        << all_messages().toStdString();
    EXPECT_TRUE(has_made(wanted(Joining::zigzag)));
    EXPECT_TRUE(says("Changed since"));
}

TEST_F(TableForm, IsNotWhatAJobThatWasTakenOverWasMadeBy) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(open_table());
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_to(OpenJobState::published));
    choose_tool_blank_and_roughing();
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(OpenJobState::job));
    ASSERT_TRUE(says("The job is ready"));
    ASSERT_TRUE(click("take_over"));
    ASSERT_TRUE(comes_to(OpenJobState::published));
    EXPECT_TRUE(window_->context().open_job.table_way()) << "the table is still open";
    EXPECT_TRUE(says("Changed since")) << part<QLabel>("desk_state").text().toStdString();
}

TEST_F(TableForm, HoldsForATableThatIsOpenedLater) {
    open_window();
    choose_tool_blank_and_roughing();
    ASSERT_NO_FATAL_FAILURE(open_table());
    EXPECT_TRUE(has_made(wanted(std::nullopt))) << all_messages().toStdString();
    EXPECT_TRUE(says("The job is ready")) << part<QLabel>("desk_state").text().toStdString();
}

TEST_F(TableForm, LocksWhatATableHasOfItselfAndSaysWhy) {
    const std::vector<const char*> own{"up", "axis_at", "height", "scale", "layers", "points", "turn", "fit"};
    const std::vector<const char*> chosen{"joining",     "tool",          "blank_radius", "blank_height",
                                          "depth_limit", "tool_diameter", "roughing",     "stepdown"};
    open_window();
    ASSERT_NO_FATAL_FAILURE(open_table());
    const QString reason = "A table's layers and radii are taken as they stand";
    for (const char* name : own) {
        EXPECT_TRUE(comes_true([&] { return !part<QWidget>(name).isEnabled(); })) << name;
        EXPECT_TRUE(part<QWidget>(name).toolTip() == reason) << name;
        EXPECT_TRUE(part<QWidget>(name).accessibleDescription() == reason) << name;
    }
    for (const char* name : {"axis_x", "axis_y"})
        EXPECT_TRUE(part<QDoubleSpinBox>(name).toolTip() == reason) << name;
    for (const char* name : chosen) EXPECT_TRUE(part<QWidget>(name).isEnabled()) << name;
    take_picture("table_form_light");
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
    for (const char* name : own) {
        EXPECT_TRUE(comes_true([&] { return part<QWidget>(name).isEnabled(); })) << name;
        EXPECT_FALSE(part<QWidget>(name).toolTip() == reason) << name;
        EXPECT_FALSE(part<QWidget>(name).accessibleDescription() == reason) << name;
    }
}

}  // namespace
}  // namespace psicarve::ui
