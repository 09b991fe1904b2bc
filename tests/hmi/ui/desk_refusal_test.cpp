// SPDX-License-Identifier: GPL-3.0-or-later
// What was not sliced or not published says so beside its button, with what would help.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>

#include <fstream>

#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using DS = session::OpenJobState;

class OpenJobRefusal : public test::WindowRig {
protected:
    QString text(const char* label) { return part<QLabel>(label).text().remove(QChar{0x200B}); }
    bool is_told() { return part<QWidget>("desk_refusal").isVisible(); }
    bool is_offered(const char* name) { return button(name).isVisible(); }
    void open(const std::string& path) {
        window_->open(QString::fromStdString(path));
        ASSERT_TRUE(comes_to(DS::model));
    }
    void slice_in_vain() {
        ASSERT_TRUE(click("slice"));
        ASSERT_TRUE(comes_true([&] { return is_told(); })) << all_messages().toStdString();
        EXPECT_EQ(text("desk_refusal_title"), "Not sliced");
        EXPECT_EQ(window_->context().open_job.view().state, DS::model);
    }
    void take_and_slice(const char* remedy) {
        ASSERT_TRUE(click(remedy));
        ASSERT_TRUE(comes_to(DS::job));
        EXPECT_FALSE(is_told());
    }
};

TEST_F(OpenJobRefusal, OfAModelTooTallHasTheHeightThatFits) {
    open_window();
    open(example("figurine.stl"));
    part<QDoubleSpinBox>("scale").setValue(10.0);
    ASSERT_NO_FATAL_FAILURE(slice_in_vain());
    EXPECT_TRUE(text("desk_refusal_why").contains("larger than the machine's travel"))
        << text("desk_refusal_why").toStdString();
    EXPECT_TRUE(is_offered("remedy_height"));
    for (const char* other : {"remedy_scale", "remedy_layers", "remedy_axis", "remedy_profile"})
        EXPECT_FALSE(is_offered(other)) << other;
    EXPECT_TRUE(button("remedy_height").text().startsWith("Height 1"))
        << button("remedy_height").text().toStdString();
    take_picture("not_sliced_light");
    window_->set_theme(ThemeChoice::dark);
    take_picture("not_sliced_dark");
    ASSERT_NO_FATAL_FAILURE(take_and_slice("remedy_height"));
    EXPECT_EQ(part<QDoubleSpinBox>("scale").value(), 0.0);
    const double height_mm = part<QDoubleSpinBox>("height").value();
    EXPECT_GT(height_mm, 100.0);
    EXPECT_LT(height_mm, 150.0);
    EXPECT_EQ(text("desk_state"), "The job is ready to be published.");
}

TEST_F(OpenJobRefusal, OfTooManyLayersHasHowManyThereCanBe) {
    open_window();
    open(example("small.stl"));
    part<QSpinBox>("layers").setValue(9999);
    part<QDoubleSpinBox>("height").setValue(3.0);
    ASSERT_NO_FATAL_FAILURE(slice_in_vain());
    ASSERT_NO_FATAL_FAILURE(take_and_slice("remedy_layers"));
    EXPECT_LT(part<QSpinBox>("layers").value(), 9999);
}

TEST_F(OpenJobRefusal, OfAModelInInchesHasTheScale) {
    std::ofstream{file("inch.obj")} << "v -.05 -.05 0\nv .05 -.05 0\nv .05 .05 0\nv -.05 .05 0\nv 0 0 .9\n"
                                       "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    open_window();
    open(file("inch.obj"));
    ASSERT_NO_FATAL_FAILURE(slice_in_vain());
    EXPECT_EQ(button("remedy_scale").text(), "Scale 25.4");
    ASSERT_NO_FATAL_FAILURE(take_and_slice("remedy_scale"));
    EXPECT_EQ(part<QDoubleSpinBox>("scale").value(), 25.4);
}

TEST_F(OpenJobRefusal, OfAnAxisBesideTheModelHasTheOneThatLosesLeast) {
    open_window();
    open(example("small.stl"));
    auto& axis = part<QComboBox>("axis_at");
    axis.setCurrentIndex(3);
    part<QDoubleSpinBox>("axis_x").setValue(9000.0);
    part<QDoubleSpinBox>("axis_y").setValue(9000.0 / 3.0);
    ASSERT_NO_FATAL_FAILURE(slice_in_vain());
    ASSERT_TRUE(is_offered("remedy_axis")) << text("desk_refusal_why").toStdString();
    ASSERT_NO_FATAL_FAILURE(take_and_slice("remedy_axis"));
    EXPECT_EQ(axis.currentIndex(), 2);
}

TEST_F(OpenJobRefusal, GoesWithTheFieldThatItWasAbout) {
    open_window();
    open(example("figurine.stl"));
    part<QDoubleSpinBox>("scale").setValue(10.0);
    ASSERT_NO_FATAL_FAILURE(slice_in_vain());
    window_->refresh();
    ASSERT_TRUE(is_told());
    part<QDoubleSpinBox>("scale").setValue(1.0);
    window_->refresh();
    EXPECT_FALSE(is_told()) << "its height would be of another scale";
}

TEST_F(OpenJobRefusal, GoesWithWhateverIsAskedForNextAndIsNoneOfACancelledOne) {
    open_window();
    open(example("figurine.stl"));
    part<QDoubleSpinBox>("scale").setValue(10.0);
    ASSERT_NO_FATAL_FAILURE(slice_in_vain());
    open(example("small.stl"));
    window_->refresh();
    EXPECT_FALSE(is_told());
    part<QDoubleSpinBox>("scale").setValue(0.0);
    part<QDoubleSpinBox>("height").setValue(100.0);
    part<QSpinBox>("layers").setValue(2000);
    part<QSpinBox>("points").setValue(2000);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(click("cancel"));
    ASSERT_TRUE(comes_true([&] { return !window_->context().open_job.view().is_busy(); }));
    EXPECT_FALSE(is_told());
}

}  // namespace
}  // namespace psicarve::ui
