// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QScopeGuard>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/unrolled_view.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using test::WindowRig;
using S = MachineState;

class Layers : public WindowRig {
protected:
    void look_at_layers() {
        window_->findChild<QTabWidget*>()->setCurrentIndex(1);
        ASSERT_TRUE(comes_true([&] { return layer().isEnabled(); }));
    }
    QSlider& layer() { return part<QSlider>("layer_slider"); }
    const MapKey& key() { return static_cast<UnrolledView&>(part<QWidget>("layer_map")).key(); }
    void show_map_of(int which) { part<QComboBox>("map_of").setCurrentIndex(which); }
    QSlider& point() { return part<QSlider>("point_slider"); }
    QCheckBox& follow() { return part<QCheckBox>("follow_machine"); }
    std::string text(const char* name) { return part<QLabel>(name).text().toStdString(); }
};

TEST_F(Layers, TellNoLeastTimeOnceTheCoreHasPlannedTheJob) {
    // No core of the window's own plans the job: then until each layer's time is known, too.
    const QByteArray path = qgetenv("PATH");
    const auto restored = qScopeGuard([&] { qputenv("PATH", path); });
    start_core();
    qputenv("PATH", "");
    open_window();
    const JobTable table = two_process::lobed_job(400, 201);
    ASSERT_NO_FATAL_FAILURE(publish_job(table));
    ASSERT_NO_FATAL_FAILURE(look_at_layers());
    layer().setValue(static_cast<int>(table.layer_count));
    ASSERT_TRUE(comes_true([&] { return session::planned_seconds(machine_view()).has_value(); }));
    window_->refresh();
    EXPECT_EQ(text("layer_until"), "about " + session::clock_text(*session::planned_seconds(machine_view())));
}

TEST_F(Layers, TellAPointsRadiiAsTheJobHasThem) {
    start_core();
    open_window();
    const JobTable table = two_process::long_job();
    ASSERT_NO_FATAL_FAILURE(publish_job(table));
    ASSERT_NO_FATAL_FAILURE(look_at_layers());
    EXPECT_FALSE(follow().isEnabled()) << "nothing is carved";
    ASSERT_EQ(layer().maximum(), static_cast<int>(table.layer_count));
    ASSERT_EQ(point().maximum() + 1, static_cast<int>(table.point_count));
    layer().setValue(3);
    point().setValue(7);
    EXPECT_EQ(part<QSpinBox>("layer_number").value(), 3);
    const std::size_t place = std::size_t{2} * table.point_count + 7;
    const auto mm = [](std::int32_t pulses, double per_mm) {
        return QString::number(pulses / per_mm, 'f', 2).toStdString() + " mm";
    };
    EXPECT_EQ(text("point_r1"), mm(table.r_left_pulses[place], Profile{}.r1.pulses_per_mm));
    EXPECT_EQ(text("point_r2"), mm(table.r_right_pulses[place], Profile{}.r2.pulses_per_mm));
    EXPECT_TRUE(part<QLabel>("point_text").text().startsWith(QString{"8 of %1, "}.arg(table.point_count)))
        << text("point_text");
    EXPECT_TRUE(part<QLabel>("layer_time").text().startsWith("at least ")) << text("layer_time");
    take_picture("layers_point_light");
}

/// Without a machine, so that nobody but a core of the window's own can plan the job; it looks for one in
/// PATH.
TEST_F(Layers, TakeAsLongAsPlannedOnceThatIsKnown) {
    const QByteArray path = qgetenv("PATH");
    const auto restored = qScopeGuard([&] { qputenv("PATH", path); });
    const auto open = [&] {
        const std::shared_ptr<const cam::PreparedJob> before = window_->context().open_job.job();
        window_->open(QString::fromStdString(file("run.job")));
        ASSERT_TRUE(comes_true([&] {
            const auto job = window_->context().open_job.job();
            return job && job != before;
        }));
        ASSERT_NO_FATAL_FAILURE(look_at_layers());
        layer().setValue(3);
    };
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(two_process::lobed_job(6, 33));
    ASSERT_TRUE(save_snapshot(snapshot, file("run.job")));
    qputenv("PATH", "");
    open_window();
    ASSERT_NO_FATAL_FAILURE(open());
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Planned time"); })) << "a core was found";
    EXPECT_TRUE(text("layer_time").starts_with("at least ")) << text("layer_time");
    EXPECT_TRUE(text("layer_until").starts_with("at least ")) << text("layer_until");
    EXPECT_TRUE(layer().toolTip().contains("takes at least ")) << layer().toolTip().toStdString();
    for (const int unknown : {1, 2}) {
        show_map_of(unknown);
        EXPECT_TRUE(key().low.startsWith("Not known: the job could not be planned"))
            << key().low.toStdString();
    }
    show_map_of(0);
    EXPECT_TRUE(key().low.endsWith(" mm")) << key().low.toStdString();
    show_map_of(2);

    qputenv("PATH", QByteArray::fromStdString(in_build("bin:")) + path);
    ASSERT_NO_FATAL_FAILURE(open());
    const auto planned = [&] {
        return window_->context().estimate.planned(window_->context().open_job.job());
    };
    ASSERT_TRUE(comes_true([&] { return planned() && !text("layer_time").starts_with("at least "); }))
        << text("layer_time") << all_messages().toStdString();
    EXPECT_EQ(text("layer_time"), session::clock_text(planned()->layer_seconds[2]));
    EXPECT_FALSE(layer().toolTip().contains("at least")) << layer().toolTip().toStdString();

    window_->refresh();
    EXPECT_EQ(key().low, "") << "it is shown once it is known";
    int percent = 0;
    for (const auto& [colour, name] : key().kinds) {
        ASSERT_TRUE(name.endsWith(" %")) << name.toStdString();
        if (!name.contains('<')) percent += name.section(' ', 1, 1).toInt();
    }
    EXPECT_NEAR(percent, 100, 4) << "some are told as less than one";
    take_picture("layers_bounds_light");
    show_map_of(1);
    EXPECT_TRUE(key().kinds.empty());
    EXPECT_EQ(key().low, "0 ms");
    EXPECT_TRUE(key().high.endsWith(" ms")) << key().high.toStdString();
    take_picture("layers_times_light");
}

TEST_F(Layers, FollowTheMachineUntilAnotherPlaceIsChosen) {
    start_core();
    open_window();
    ASSERT_NO_FATAL_FAILURE(carve_job(two_process::long_job()));
    ASSERT_NO_FATAL_FAILURE(look_at_layers());
    const auto machine_layer = [&] { return static_cast<int>(machine_view().status->layer) + 1; };
    ASSERT_TRUE(comes_true([&] { return machine_layer() > 1 && layer().value() == machine_layer(); }));
    EXPECT_TRUE(follow().isEnabled());
    EXPECT_TRUE(follow().isChecked());
    layer().setValue(layer().maximum());
    EXPECT_FALSE(follow().isChecked());
    const int before = machine_layer();
    ASSERT_TRUE(comes_true([&] { return machine_layer() > before; }));
    EXPECT_EQ(layer().value(), layer().maximum()) << "another layer of the machine takes it away";
    follow().click();
    EXPECT_TRUE(comes_true([&] { return layer().value() == machine_layer(); }));
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
}

}  // namespace
}  // namespace psicarve::ui
