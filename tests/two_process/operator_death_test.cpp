// SPDX-License-Identifier: GPL-3.0-or-later
// Operators' programs that die at any instant: nothing of it may reach the motion.
#include <array>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/two_process/child_process.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr int kDeaths = 1000;
constexpr std::uint32_t kLayers = 30;

/// Publishes and commands without a pause, in an order of its own for each seed. Does not come back.
[[noreturn]] void command_for_ever(const std::string& segment_name, const std::vector<std::byte>& job,
                                   unsigned seed) {
    constexpr milliseconds kPatience{1000};
    constexpr std::array kKinds{
        CommandKind::home,    CommandKind::start,       CommandKind::start_interpolation,
        CommandKind::hold,    CommandKind::resume,      CommandKind::override,
        CommandKind::spindle, CommandKind::reset_height};
    std::mt19937 random{seed};
    auto segment = Segment::attach(segment_name);
    while (segment) {
        const auto choice = random() % 12;
        if (choice == 0) {
            (void)publish_job(*segment, job, kPatience).has_value();
        } else if (choice == 1) {
            request_stop(*segment);
        } else {
            Command command{};
            command.kind = kKinds[random() % kKinds.size()];
            command.value = static_cast<double>(random() % 120);
            if (command.kind == CommandKind::start) command.value = static_cast<double>(random() % kLayers);
            if (command.kind == CommandKind::spindle) command.value = static_cast<double>(random() % 2);
            (void)send_command(*segment, command, kPatience).has_value();
        }
    }
    ::_exit(1);
}

class OperatorDeath : public CoreRig {
protected:
    void expect_exact_motion(const CoreStatus& now) {
        EXPECT_EQ(now.alarm_count, 0U) << name_of(now.alarms[0].cause);
        for (const Axis axis : kAllAxes) {
            const std::size_t k = index_of(axis);
            EXPECT_EQ(now.sim_ignored_pulses[k] + now.sim_timing_lost[k] + now.sim_stalls[k], 0U)
                << name_of(axis);
            // Whole turns are dropped from psi's count when a job starts.
            const std::int64_t off = now.sim_true_position_pulses[k] - now.position_pulses[k];
            EXPECT_EQ(axis == Axis::psi ? off % Profile{}.psi.pulses_per_rev : off, 0) << name_of(axis);
        }
    }
    std::size_t used_slots() const {
        std::size_t used = 0;
        for (const CommandSlot& slot : segment_->header().commands) used += slot.state_and_sender.load() != 0;
        return used;
    }
};

TEST_F(OperatorDeath, AThousandAtAnyInstantDisturbNoPulse) {
    start_core();
    home();
    const JobTable table = lobed_job(kLayers, 41);
    const std::vector<std::byte> job = job_blob_from_table(table);
    ASSERT_EQ(publish(table), "");
    std::mt19937 random{20261121};
    std::uint64_t points = 0;
    for (int death = 0; death < kDeaths; ++death) {
        test::ChildProcess child{[&](const test::ChildProcess::Signal& /*began*/) {
            command_for_ever(segment_name_, job, static_cast<unsigned>(death));
        }};
        std::this_thread::sleep_for(std::chrono::microseconds{static_cast<int>(random() % 4000)});
        child.kill();
        points = std::max(points, status().points_done);
        if (death % 100 != 0) continue;
        ASSERT_TRUE(segment_->core_pid()) << "after " << death;
        ASSERT_EQ(refusal_of(CommandKind::override, 100.0), "") << "after " << death;
    }
    // The lives are random, and a busy computer gives them little time: more of them until something was
    // carved.
    for (unsigned life = kDeaths; points <= 41U && life < 10 * kDeaths; ++life) {
        test::ChildProcess child{
            [&](const test::ChildProcess::Signal& /*began*/) { command_for_ever(segment_name_, job, life); }};
        eventually([&] { return status().points_done > 41U; }, milliseconds{200});
        child.kill();
        points = std::max(points, status().points_done);
    }
    EXPECT_GT(points, 41U) << "something was carved meanwhile";
    request_stop(*segment_);
    ASSERT_TRUE(eventually([&] {
        const MachineState state = status().state;
        return state == MachineState::ready || state == MachineState::off;
    })) << name_of(status().state)
        << " at tick " << status().tick;
    expect_exact_motion(status());
    EXPECT_TRUE(eventually([&] { return used_slots() == 0; })) << used_slots() << " slots are lost";
    home();
    ASSERT_EQ(publish(table), "");
    ASSERT_EQ(refusal_of(CommandKind::override, 100.0), "");
    start_carving();
    ASSERT_TRUE(
        eventually([&] { return status().job_end_tick != 0 && status().points_done == kLayers * 41U; }));
    expect_exact_motion(status());
}

}  // namespace
}  // namespace psicarve::two_process
