// SPDX-License-Identifier: GPL-3.0-or-later
// What `psicarve slice` takes as options, in the window.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>
#include <algorithm>

#include "hmi/ui/model_form.hpp"
#include "hmi/ui/pass_view.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

class ModelFormOf : public test::WindowRig {
protected:
    template <typename T>
    T& field(const char* name) {
        auto* const found = sut_.findChild<T*>(name);
        if (found == nullptr) throw std::runtime_error{std::string{"no field "} + name};
        return *found;
    }
    void choose(const char* name, int index) { field<QComboBox>(name).setCurrentIndex(index); }
    void set(const char* name, double value) { field<QDoubleSpinBox>(name).setValue(value); }

    int replaced_ = 0;
    int reshaped_ = 0;
    ModelForm sut_{[this] { ++replaced_; }, [this] { ++reshaped_; }};
};

TEST_F(ModelFormOf, LeavesEverythingToModelAndProfileAtFirst) {
    const cam::JobOptions options = sut_.options();
    EXPECT_FALSE(options.height_mm || options.scale || options.layer_count || options.point_count ||
                 options.joining);
    EXPECT_EQ(options.axis_at, cam::AxisAt::centre);
    Profile machine;
    machine.tool.shape = ToolShape::flat;
    machine.blank.radius_mm = 12.0;
    EXPECT_EQ(sut_.profile_for(machine).tool, machine.tool);
    EXPECT_EQ(sut_.profile_for(machine).blank, machine.blank);
}

TEST_F(ModelFormOf, PlacesTheModel) {
    choose("up", 2);
    choose("axis_at", 3);
    set("axis_x", -1.5);
    set("axis_y", 2.25);
    EXPECT_EQ(replaced_, 4);
    cam::JobOptions options = sut_.options();
    EXPECT_EQ(options.up, slice::Up::x);
    EXPECT_EQ(options.axis_at, cam::AxisAt::point);
    EXPECT_DOUBLE_EQ(options.axis_x, -1.5);
    EXPECT_DOUBLE_EQ(options.axis_y, 2.25);
    set("scale", 25.4);
    EXPECT_EQ(sut_.options().scale, 25.4);
    EXPECT_FALSE(field<QDoubleSpinBox>("height").isEnabled());
    EXPECT_EQ(field<QDoubleSpinBox>("height").toolTip(), "Scale sets it");
    set("scale", 0.0);
    set("height", 40.0);
    options = sut_.options();
    EXPECT_EQ(options.height_mm, 40.0);
    EXPECT_FALSE(options.scale);
    EXPECT_FALSE(field<QDoubleSpinBox>("scale").isEnabled());
}

TEST_F(ModelFormOf, StandsMeshesUpAndNothingElse) {
    choose("up", 1);
    EXPECT_EQ(replaced_, 1);
    for (const flat::ModelKind kind : {flat::ModelKind::drawing, flat::ModelKind::picture}) {
        sut_.begin(kind, false);
        EXPECT_EQ(sut_.options().up, slice::Up::z);
    }
    choose("up", 2);  // by settings that came late
    EXPECT_EQ(sut_.options().up, slice::Up::z);
    EXPECT_EQ(replaced_ + reshaped_, 1) << "nothing is other than before";
    sut_.begin(flat::ModelKind::mesh, false);
    EXPECT_EQ(sut_.options().up, slice::Up::x) << "as it was chosen";
}

TEST_F(ModelFormOf, TakesToolAndBlankInsteadOfTheProfiles) {
    sut_.show();
    EXPECT_FALSE(field<QDoubleSpinBox>("tool_diameter").isVisible());
    choose("tool", 4);
    EXPECT_TRUE(field<QDoubleSpinBox>("tool_angle").isVisible());
    set("tool_diameter", 6.0);
    set("tool_angle", 45.0);
    set("blank_radius", 30.0);
    set("blank_height", 60.0);
    const Profile profile = sut_.profile_for(Profile{});
    EXPECT_EQ(profile.tool.shape, ToolShape::vee);
    EXPECT_DOUBLE_EQ(profile.tool.diameter_mm, 6.0);
    EXPECT_DOUBLE_EQ(profile.tool.angle_deg, 45.0);
    EXPECT_DOUBLE_EQ(profile.blank.radius_mm, 30.0);
    EXPECT_DOUBLE_EQ(profile.blank.height_mm, 60.0);
    Profile machine;
    machine.tool.flute_mm = 9.0;
    EXPECT_DOUBLE_EQ(sut_.profile_for(machine).tool.flute_mm, 9.0) << "until another is told";
    EXPECT_TRUE(field<QDoubleSpinBox>("tool_flute").isVisible());
    set("tool_flute", 14.0);
    EXPECT_DOUBLE_EQ(sut_.profile_for(machine).tool.flute_mm, 14.0);
    choose("tool", 1);
    EXPECT_FALSE(field<QDoubleSpinBox>("tool_flute").isVisible());
    EXPECT_FALSE(field<QDoubleSpinBox>("tool_diameter").isVisible());
    EXPECT_EQ(sut_.profile_for(Profile{}).tool.shape, ToolShape::point);
    EXPECT_EQ(replaced_, 0) << "a tool moves no model";
}

TEST_F(ModelFormOf, TakesWhereTheBlankStandsAndHowDeepItMayBeCut) {
    Profile machine;
    machine.blank = {12.0, 30.0, 1.0, 2.0, 3.0};
    sut_.show();
    EXPECT_FALSE(field<QDoubleSpinBox>("blank_x").isVisible());
    EXPECT_EQ(sut_.profile_for(machine).blank, machine.blank);
    set("blank_radius", 20.0);
    EXPECT_TRUE(field<QDoubleSpinBox>("depth_limit").isVisible());
    set("blank_x", -1.5);
    set("blank_z", 2.5);
    EXPECT_EQ(sut_.profile_for(machine).blank, (BlankProfile{20.0, 30.0, -1.5, 2.5, 3.0}));
    set("depth_limit", 8.0);
    EXPECT_DOUBLE_EQ(sut_.profile_for(machine).blank.depth_limit_mm, 8.0);
}

TEST_F(ModelFormOf, RoughsAsTheProfileUnlessAnotherWayIsChosen) {
    Profile machine;
    machine.tool = {ToolShape::ball, 2.0};
    machine.blank.radius_mm = 12.0;
    machine.roughing = {3.0, 0.5, 1.25};
    sut_.show();
    sut_.show_passes(machine);
    EXPECT_EQ(sut_.profile_for(machine), machine);
    EXPECT_FALSE(field<QDoubleSpinBox>("stepdown").isVisible());
    EXPECT_TRUE(field<QLabel>("pass_note").text().startsWith("Up to 4 roughing passes, layers 1.25 mm apart"))
        << field<QLabel>("pass_note").text().toStdString();
    choose("roughing", 1);
    EXPECT_EQ(sut_.profile_for(machine), machine) << "the fields begin with the profile's";
    EXPECT_TRUE(field<QDoubleSpinBox>("stepover").isVisible());
    choose("roughing", 0);
    EXPECT_FALSE(field<QDoubleSpinBox>("stepover").isVisible());
    choose("roughing", 1);
    EXPECT_TRUE(field<QDoubleSpinBox>("stepover").isVisible()) << "though the passes stay the same";
    set("stepdown", 2.0);
    set("allowance", 0.0);
    set("stepover", 0.0);
    EXPECT_EQ(sut_.profile_for(machine).roughing, (RoughingProfile{2.0, 0.0, 0.0}));
    choose("tool", 1);
    sut_.show_passes(machine);
    EXPECT_FALSE(field<QDoubleSpinBox>("stepover").isVisible()) << "a point carves every layer";
    choose("roughing", 2);
    EXPECT_EQ(sut_.profile_for(machine).roughing.stepdown_mm, 0.0);
    EXPECT_EQ(field<QLabel>("pass_note").text(), "The finishing pass alone");
    choose("roughing", 1);
    EXPECT_EQ(sut_.profile_for(machine).roughing.stepdown_mm, 2.0) << "what was typed is kept";
}

TEST_F(ModelFormOf, DrawsThePassesAndSaysWhatIsWrongWithThem) {
    Profile machine;
    machine.roughing.stepdown_mm = 2.0;
    sut_.show();
    sut_.show_passes(machine);
    const auto& picture = field<PassView>("pass_view");
    EXPECT_FALSE(picture.isVisible());
    EXPECT_EQ(field<QLabel>("pass_note").property("role"), "problem");
    EXPECT_EQ(field<QLabel>("pass_note").text(),
              "roughing begins at the blank's surface: say how large the blank is, or choose finishing only");
    set("blank_radius", 10.0);
    sut_.show_passes(machine);
    EXPECT_TRUE(picture.isVisible());
    EXPECT_EQ(picture.sketch().depths_mm.size(), 5U) << "8, 6, 4, 2 and 1.8 mm";
    EXPECT_EQ(field<QLabel>("pass_note").property("role"), "label");
    choose("roughing", 1);
    set("stepdown", 4.0);
    EXPECT_EQ(picture.sketch().depths_mm.size(), 3U) << "at once, as it is typed";
    choose("tool", 2);
    set("tool_diameter", 2.0);
    set("stepover", 2.5);
    sut_.show_passes(machine);
    EXPECT_EQ(field<QLabel>("pass_note").text(), "a stepover of 2.5 mm is more than the tool is wide, 2 mm");
}

TEST_F(ModelFormOf, DrawsAToolAloneBeforeThereIsABlank) {
    sut_.show();
    sut_.show_passes(Profile{});
    const auto& picture = field<PassView>("pass_view");
    EXPECT_FALSE(picture.isVisible()) << "a point has no shape";
    choose("tool", 2);
    set("tool_flute", 8.0);
    sut_.show_passes(Profile{});
    EXPECT_TRUE(picture.isVisible());
    EXPECT_EQ(picture.sketch().shank.size(), 4U);
    EXPECT_EQ(field<QLabel>("pass_note").text(), "The tool alone: no blank is chosen");
}

TEST_F(ModelFormOf, EngravesTheLinesOfADrawing) {
    Profile machine;
    machine.tool = {ToolShape::ball, 2.0};
    machine.blank.radius_mm = 15.0;
    sut_.show();
    EXPECT_FALSE(field<QCheckBox>("engrave").isVisible()) << "not of a mesh";
    sut_.begin(flat::ModelKind::drawing);
    EXPECT_FALSE(sut_.flat_options(machine).engraving);
    EXPECT_FALSE(field<QDoubleSpinBox>("engrave_depth").isVisible());
    choose("axis_at", 1);
    set("scale", 0.5);
    reshaped_ = 0;
    field<QCheckBox>("engrave").click();
    EXPECT_EQ(reshaped_, 1);
    EXPECT_TRUE(field<QDoubleSpinBox>("engrave_depth").isVisible());
    EXPECT_FALSE(field<QComboBox>("axis_at").isVisible());
    set("engrave_depth", 0.25);
    set("engrave_start", 90.0);
    field<QCheckBox>("engrave_widths").click();
    flat::FlatOptions options = sut_.flat_options(machine);
    ASSERT_TRUE(options.engraving);
    EXPECT_DOUBLE_EQ(options.engraving->depth_mm, 0.25);
    EXPECT_DOUBLE_EQ(options.engraving->start_deg, 90.0);
    EXPECT_TRUE(options.engraving->follows_strokes);
    EXPECT_EQ(options.engraving->tool, machine.tool);
    EXPECT_EQ(options.diameter_mm, 30.0);
    EXPECT_DOUBLE_EQ(options.scale, 0.5);
    EXPECT_EQ(sut_.options().axis_at, cam::AxisAt::centre);
    set("engrave_diameter", 44.0);
    field<QCheckBox>("engrave_full_turn").click();
    reshaped_ = 0;
    choose("tool", 3);
    EXPECT_EQ(reshaped_, 1) << "its grooves are as wide as the tool";
    options = sut_.flat_options(machine);
    EXPECT_EQ(options.diameter_mm, 44.0);
    EXPECT_TRUE(options.is_full_turn);
    EXPECT_EQ(options.engraving->tool.shape, ToolShape::flat);
    sut_.begin(flat::ModelKind::drawing);
    EXPECT_FALSE(sut_.flat_options(machine).engraving) << "as for a new one";
}

TEST_F(ModelFormOf, SlicesEngravedLines) {
    open_window();
    window_->open(QString::fromStdString(example("flower.svg")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    part<QSpinBox>("layers").setValue(40);
    part<QSpinBox>("points").setValue(200);
    part<QComboBox>("tool").setCurrentIndex(2);
    part<QDoubleSpinBox>("tool_diameter").setValue(1.0);
    button("engrave").click();
    ASSERT_TRUE(comes_true([&] {
        return window_->context().open_job.mesh() != nullptr &&
               window_->context().open_job.mesh()->grooves != nullptr;
    })) << all_messages().toStdString();
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job)) << all_messages().toStdString();
    EXPECT_DOUBLE_EQ(window_->context().open_job.job()->profile.tool.diameter_mm, 1.0);
    take_picture("engraved_light");
}

TEST_F(ModelFormOf, SlicesWithWhatWasChosen) {
    open_window();
    window_->open(QString::fromStdString(example("figurine.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    ASSERT_TRUE(comes_true([&] {
        return part<QLabel>("mesh_facts").text().contains("90\u2009184 facets, ");
    })) << part<QLabel>("mesh_facts").text().toStdString();
    part<QSpinBox>("layers").setValue(20);
    part<QSpinBox>("points").setValue(20);
    part<QDoubleSpinBox>("scale").setValue(0.5);
    part<QComboBox>("joining").setCurrentIndex(2);
    part<QComboBox>("tool").setCurrentIndex(2);
    part<QDoubleSpinBox>("tool_diameter").setValue(2.0);
    part<QDoubleSpinBox>("blank_radius").setValue(9.0);
    part<QComboBox>("roughing").setCurrentIndex(1);
    part<QDoubleSpinBox>("stepdown").setValue(2.0);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job)) << all_messages().toStdString();
    const auto job = window_->context().open_job.job();
    ASSERT_GE(job->view.passes().size(), 3U);
    EXPECT_EQ(job->view.passes()[0].depth_mm, 7.0);
    EXPECT_EQ(job->view.layer_count() - job->view.finishing_layer(), 20U);
    EXPECT_EQ(job->view.joining(), Joining::zigzag);
    EXPECT_EQ(job->profile.tool.shape, ToolShape::ball);
    EXPECT_DOUBLE_EQ(job->profile.tool.diameter_mm, 2.0);
    const auto& picture = part<PassView>("pass_view");
    EXPECT_EQ(picture.height(), static_cast<int>(picture.width() * PassView::kRatio)) << "all to one scale";
    EXPECT_TRUE(comes_true([&] {
        const auto labels = window_->findChildren<QLabel*>("blank_label");
        return std::ranges::any_of(
            labels, [](const QLabel* label) { return label->text() == QStringLiteral("blank ⌀ 18.0 mm"); });
    })) << "the blank that was chosen";
    const QWidget& publish = button("publish");
    EXPECT_TRUE(comes_true([&] { return publish.visibleRegion() == QRegion{publish.rect()}; }))
        << "out of sight with all fields there are";
    take_picture("model_form_light");
    window_->set_theme(ThemeChoice::dark);
    take_picture("model_form_dark");
}

}  // namespace
}  // namespace psicarve::ui
