// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

/// A coarse, slow machine: a gap in ticks that a busy computer makes loses no step of it, and it homes in
/// seconds.
Profile slow_machine() {
    Profile profile;
    profile.name = "slow";
    profile.tick.period_us = 1000.0;
    profile.tick.missed_alarm_per_s = 0;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->pulses_per_mm = 10.0;
        axis->speed_mm_s = 40.0;
        axis->accel_mm_s2 = 200.0;
        axis->start_stop_mm_s = 1.0;
        axis->home_speed_mm_s = 20.0;
        axis->overtravel_mm = 3.0;
    }
    profile.psi.pulses_per_rev = 200;
    profile.psi.speed_deg_s = 360.0;
    profile.psi.accel_deg_s2 = 720.0;
    profile.psi.start_stop_deg_s = 18.0;
    profile.psi.home_speed_deg_s = 90.0;
    profile.job.feed_mm_s = 200.0;
    profile.job.plunge_mm_s = 40.0;
    profile.job.spindle_spinup_s = 0.1;
    return profile;
}

JobTable square_job(const Profile& profile) {
    JobTable table = lobed_job(2, 9, profile);
    for (std::size_t layer = 0; layer < 2; ++layer) {
        table.layer_height_pulses[layer] = 20 + 2 * static_cast<std::int64_t>(layer);
    }
    return table;
}

class CoreOnTheRealClock : public CoreRig {};

// Three threads meet here: also run under ThreadSanitizer, whose findings end the core with another exit
// code.
TEST_F(CoreOnTheRealClock, HomesCarvesAndEndsInOrder) {
    const Profile profile = slow_machine();
    const std::string text = profile_to_toml(profile);
    ASSERT_TRUE(write_file_atomically(file("slow.toml"), std::as_bytes(std::span{text})));
    core_ = std::make_unique<CoreProcess>(
        std::vector<std::string>{"--segment", segment_name_, "--clock", "real", "--profile",
                                 file("slow.toml"), "--trace", file("real.trace"), "--capacity", "10x20"},
        file("core.err"));
    attach();
    ASSERT_TRUE(eventually([&] { return segment_->core_pid() == std::uint32_t(core_->pid()); }))
        << text_of(file("core.err"));
    home();
    ASSERT_EQ(publish(square_job(profile)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] {
        const CoreStatus now = status();
        return now.job_end_tick != 0 || now.state == MachineState::alarm;
    }));
    const CoreStatus end = status();
    EXPECT_EQ(end.state, MachineState::ready) << name_of(end.alarm_cause);
    EXPECT_EQ(end.points_done, 18U);
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(end.sim_true_position_pulses[index_of(axis)], end.position_pulses[index_of(axis)])
            << name_of(axis);
    }
    EXPECT_EQ(end.trace_lost, 0U);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
}

}  // namespace
}  // namespace psicarve::two_process
