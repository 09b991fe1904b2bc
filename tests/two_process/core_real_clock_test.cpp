// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <sstream>

#include "shared/computer/realtime_step.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/core_rig.hpp"
#include "tests/two_process/slow_machine.hpp"

namespace psicarve::two_process {
namespace {

JobTable square_job(const Profile& profile) {
    JobTable table = lobed_job(2, 9, profile);
    for (std::size_t layer = 0; layer < 2; ++layer) {
        table.layer_height_pulses[layer] = 20 + 2 * static_cast<std::int64_t>(layer);
    }
    return table;
}

class CoreOnTheRealClock : public CoreRig {
protected:
    void start_core_with(const Profile& profile, std::vector<std::string> more = {}) {
        const std::string text = profile_to_toml(profile);
        ASSERT_TRUE(write_file_atomically(file("machine.toml"), std::as_bytes(std::span{text})));
        std::vector<std::string> arguments{"--segment", segment_name_,        "--clock",    "real",
                                           "--profile", file("machine.toml"), "--capacity", "10x20"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        core_ = std::make_unique<CoreProcess>(arguments, file("core.err"));
        attach();
        ASSERT_TRUE(eventually([&] { return segment_->core_pid() == std::uint32_t(core_->pid()); }))
            << text_of(file("core.err"));
    }
    void home_and_carve_in_order(const Profile& profile);
};

/// A machine that creeps: whatever a busy computer does to its ticks, no rotor coasts into a lost step.
Profile creeping_machine() {
    Profile profile = slow_machine();
    profile.tick.period_us = 5000.0;
    profile.tick.missed_alarm_per_s = 150;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->start_stop_mm_s = 0.001;
        axis->home = HomeSensor::none;
        axis->speed_mm_s = 8.0;
        axis->home_speed_mm_s = 8.0;
        axis->accel_mm_s2 = 50.0;
    }
    profile.psi.speed_deg_s = 90.0;
    profile.psi.home_speed_deg_s = 90.0;
    profile.psi.accel_deg_s2 = 720.0;
    profile.psi.start_stop_deg_s = 0.02;
    profile.psi.home = HomeSensor::none;
    return profile;
}

/// The priority of the process's first thread, as the kernel tells it.
std::string realtime_priority(pid_t process) {
    const std::string stat = text_of("/proc/" + std::to_string(process) + "/stat");
    std::istringstream fields{stat.substr(std::min(stat.rfind(')') + 1, stat.size()))};
    constexpr int kPriorityField =
        38;  // proc(5): rt_priority is number 40, the state behind the name number 3
    std::string field;
    for (int i = 0; i < kPriorityField; ++i) fields >> field;
    return field;
}

void CoreOnTheRealClock::home_and_carve_in_order(const Profile& profile) {
    ASSERT_NO_FATAL_FAILURE(start_core_with(profile, {"--trace", file("real.trace")}));
    home();
    std::array<std::int64_t, kAxisCount> offset_pulses{};
    for (const Axis axis : kAllAxes) {
        if (axis_motion(profile, axis).home != HomeSensor::none) continue;
        const CoreStatus homed = status();
        offset_pulses[index_of(axis)] =
            homed.sim_true_position_pulses[index_of(axis)] - homed.position_pulses[index_of(axis)];
    }
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
        // One without a sensor was homed where it stood, at a count of its own.
        EXPECT_EQ(end.sim_true_position_pulses[index_of(axis)] - end.position_pulses[index_of(axis)],
                  offset_pulses[index_of(axis)])
            << name_of(axis);
    }
    EXPECT_EQ(end.trace_lost, 0U);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
}

/// Looks for a limit and for the index; homing the other axes on the real clock only takes as long again.
Profile machine_with_two_sensors() {
    Profile profile = slow_machine();
    profile.r2.home = HomeSensor::none;
    profile.y.home = HomeSensor::none;
    return profile;
}

// Three threads meet here: also run under ThreadSanitizer, whose findings end the core with another exit
// code.
TEST_F(CoreOnTheRealClock, HomesCarvesAndEndsInOrder) {
    Profile profile = machine_with_two_sensors();
    // Its index is looked for below, and by dev here, too.
    if (!test::is_thorough()) profile.psi.home = HomeSensor::none;
    home_and_carve_in_order(profile);
}

// Four: inputs and pulses have one of their own.
TEST_F(CoreOnTheRealClock, HomesCarvesAndEndsInOrderByTwoTimersToo) {
    Profile profile = machine_with_two_sensors();
    profile.tick.schedule = Schedule::two_timer;
    profile.tick.interpolation_us = 1000.0;
    profile.tick.io_us = 2000.0;
    home_and_carve_in_order(profile);
}

TEST_F(CoreOnTheRealClock, TellsHowItsTickIsTreatedAndWhatToDo) {
    ASSERT_NO_FATAL_FAILURE(start_core_with(slow_machine(), {"--cpu", "0", "--priority", "7"}));
    ASSERT_TRUE(eventually([&] { return status().realtime_asked != 0; }));
    const CoreStatus now = status();
    EXPECT_NE(now.realtime_asked & bit_of(RealtimeStep::tick_cpu), 0U);
    const bool has_cpu = (now.realtime_done & bit_of(RealtimeStep::tick_cpu)) != 0;
    EXPECT_EQ(now.tick_cpu, has_cpu ? 0 : -1);
    const bool is_realtime = (now.realtime_done & bit_of(RealtimeStep::scheduling)) != 0;
    EXPECT_EQ(now.tick_priority, is_realtime ? 7U : 0U);
    EXPECT_EQ(now.has_realtime_rights != 0,
              (now.realtime_done & kNeededRealtimeSteps) == kNeededRealtimeSteps);
    ASSERT_TRUE(eventually([&] { return status().tick_sleeps > 0; }));
    // No more than one a tick; a few before the first.
    const CoreStatus later = status();
    EXPECT_LE(later.tick_sleeps, later.tick + 4);
    // The thread that serves commands has the least realtime priority while it waits, and is an ordinary
    // thread while it does the rest.
    EXPECT_TRUE(eventually([&] { return realtime_priority(core_->pid()) == (is_realtime ? "1" : "0"); }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
    const std::string said = text_of(file("core.err"));
    EXPECT_EQ(said.find("processor of the tick: refused: ") == std::string::npos, has_cpu) << said;
}

TEST_F(CoreOnTheRealClock, StopsInOrderWhenTooManyTicksAreMissed) {
    ASSERT_NO_FATAL_FAILURE(start_core_with(creeping_machine()));
    home();
    // Without sensors it is homed where it stands: at a count of its own.
    const std::int64_t offset = status().sim_true_position_pulses[0] - status().position_pulses[0];
    Command move{};
    move.kind = CommandKind::move;
    move.axis = 1;
    move.target[0] = 2.0;
    ASSERT_EQ(refusal_of(move), "");
    ASSERT_TRUE(eventually([&] { return status().state == MachineState::moving; }));
    const std::uint64_t missed_before = status().missed_ticks;
    // 300 of its ticks, of which it forgives 150.
    core_->send_signal(SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds{1500});
    core_->send_signal(SIGCONT);
    ASSERT_TRUE(reaches(MachineState::alarm));
    const CoreStatus end = status();
    EXPECT_EQ(end.alarm_cause, AlarmCause::missed_ticks) << name_of(end.alarm_cause);
    EXPECT_GT(end.missed_ticks, missed_before + 150);
    // In order: no step was lost on the way to rest.
    EXPECT_EQ(end.homed_mask, 0) << "its drives are off";
    EXPECT_EQ(end.sim_true_position_pulses[0] - end.position_pulses[0], offset);
    EXPECT_EQ(end.sim_stalls[0], 0U);
}

}  // namespace
}  // namespace psicarve::two_process
