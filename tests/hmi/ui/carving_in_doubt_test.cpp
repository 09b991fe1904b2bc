// SPDX-License-Identifier: GPL-3.0-or-later
// The page Carving after an alarm of lost steps: what of the piece can be wrong.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTabWidget>

#include <algorithm>
#include <fstream>

#include "hmi/ui/colour_bar.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

/// The table makes more steps a turn than the profile says: as if it lost some in each.
class CarvingInDoubt : public test::WindowRig {
protected:
    QString told() {
        return part<QLabel>("carving_doubt").isVisible() ? part<QLabel>("carving_doubt").text() : QString{};
    }
    std::ptrdiff_t vertices_in_doubt() {
        const auto& bodies = part<MeshView>("carving_view").picture().bodies;
        if (bodies.empty()) return 0;
        const auto& rgb = bodies.front().scene->vertex_rgb;
        return std::count(rgb.begin(), rgb.end(), kDoubtColour & 0xFFFFFFU);
    }
};

TEST_F(CarvingInDoubt, LayersOfLostStepsArePaintedUntilTheyAreCarvedAgain) {
    Profile profile;
    profile.blank.radius_mm = 30.0;
    std::ofstream{file("machine.toml")} << profile_to_toml(profile);
    Profile real = profile;
    real.psi.pulses_per_rev += 10;
    std::ofstream{file("real.toml")} << profile_to_toml(real);
    window_.reset();
    start_core({"--profile", file("machine.toml"), "--machine", file("real.toml")});
    open_window();
    window_->findChild<QTabWidget*>()->setCurrentIndex(2);
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::lobed_job(9, 33, profile)));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(MachineState::alarm));
    ASSERT_EQ(machine_view().status->alarm_cause, AlarmCause::steps_lost);
    const AlarmRecord alarm = machine_view().status->alarms[0];
    ASSERT_GT(alarm.layer_count, 1U);
    ASSERT_TRUE(comes_true([&] { return vertices_in_doubt() > 0; }));
    const QString layers = QStringLiteral("Layers 1 to %1 can be wrong (≤ 0.").arg(alarm.layer_count);
    EXPECT_TRUE(told().contains(layers)) << told().toStdString();
    take_picture("carving_in_doubt_light");
    ASSERT_TRUE(click("reset_alarm"));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    EXPECT_TRUE(told().contains(layers)) << "the piece is what it was";
    // Less than a turn: the table's index has nothing to say of it.
    window_->context().machine.start(0, 1);
    ASSERT_TRUE(comes_true([&] {
        return machine_view().state() == MachineState::ready && machine_view().resumable_layer == 1U;
    })) << all_messages().toStdString();
    const QString left = QStringLiteral("Layers 2 to %1 can be wrong").arg(alarm.layer_count);
    EXPECT_TRUE(comes_true([&] { return told().contains(left); })) << told().toStdString();
    EXPECT_TRUE(comes_true([&] { return vertices_in_doubt() == 0; }))
        << "the others are shown as the blank: it was begun anew";
}

}  // namespace
}  // namespace psicarve::ui
