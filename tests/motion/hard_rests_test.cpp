// SPDX-License-Identifier: GPL-3.0-or-later
// Rests where no curve keeps the tolerance, carved by the executor: at any override no motor is asked for
// more than it has, and what leads up to such a rest and away from it goes slowly enough to rest.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "hmi/verify/motor_rule.hpp"
#include "hmi/verify/verify_report.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/rtcore/cycle/path_rig.hpp"
#include "tests/rtcore/plan/hard_paths.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

using cycle::BlockKind;
using cycle::Executor;
using cycle::MotionBlock;
using plan::MachineLimits;

constexpr plan::test::HardMachine kRestingMachines[] = {
    plan::test::kHardMachines[0], plan::test::kHardMachines[1], plan::test::kHardMachines[2],
    plan::test::kHardMachines[4]};
constexpr std::uint64_t kMostHardTicks = 60'000'000;

Profile small_steps_profile(const plan::test::HardMachine& machine, double tolerance_pulses) {
    Profile profile = plan::test::hard_profile(machine);
    profile.job.spindle_spinup_s = 0.01;
    profile.job.path_tolerance_mm = tolerance_pulses / machine.pulses_per_mm;
    return profile;
}

std::vector<MotionBlock> hard_program_blocks(const MachineLimits& limits,
                                             const plan::test::WayScript& program) {
    plan::RecordProgram sut(limits, std::make_shared<plan::test::ScriptedSource>(program.script.steps),
                            program.points.front());
    std::vector<MotionBlock> blocks;
    MotionBlock block;
    while (sut.next(block)) {
        if (block.kind == BlockKind::path || block.kind == BlockKind::program_end) blocks.push_back(block);
    }
    return blocks;
}

/// Both timings, at both sides of each joint.
void expect_joints_of_rests(const std::vector<MotionBlock>& blocks, std::uint64_t seed) {
    constexpr double kNothing2 = 1e-15;
    std::uint32_t left = 0;
    plan::Timings before{};
    for (const MotionBlock& block : blocks) {
        if (block.kind != BlockKind::path) continue;
        const bool begins = left == 0;
        if (begins) left = block.group_blocks;
        const bool goes_in = begins && (block.joints & cycle::kCarriesOn) == 0;
        const bool goes_out = left == 1 && (block.joints & cycle::kGoesOn) == 0;
        const double stop = block.path.start_stop_speed;
        for (std::size_t t = 0; t < plan::kTimingCount; ++t) {
            if (goes_in) {
                EXPECT_LE(block.path.start_speed2[t], 1.1 * stop * stop) << "seed " << seed;
            } else {
                EXPECT_NEAR(block.path.start_speed2[t], before[t], 1e-9 * before[t] + kNothing2)
                    << "seed " << seed;
            }
            EXPECT_TRUE(!goes_out || block.path.end_speed2[t] <= 1.1 * stop * stop) << "seed " << seed;
            before[t] = block.path.end_speed2[t];
        }
        --left;
    }
}

/// What the motor rule says of the pulses, at that override; 0: another one now and then, and holds.
void expect_motors_follow(const Profile& profile, const MachineLimits& limits,
                          const plan::test::WayScript& program, const std::vector<MotionBlock>& blocks,
                          int override_percent) {
    cycle::PathRig rig{limits.tick};
    rig.pulses.set_enables(0xF, 0);
    for (std::size_t k = 0; k < kAxisCount; ++k) rig.pulses.set_position(k, program.points.front()[k]);
    rig.program = blocks;
    verify::OffenceLog log;
    verify::MotorRule rule(profile, log);
    const std::int64_t period_ns = tick_period_ns(profile);
    rule.begin(period_ns);
    std::mt19937_64 random{7};
    std::uint64_t next_hand = 0;
    if (override_percent > 0) rig.executor.set_feed_ratio(0.01 * override_percent);
    while ((rig.seen & Executor::kProgramEnd) == 0 && rig.now < kMostHardTicks) {
        if (override_percent == 0 && rig.now >= next_hand) {
            next_hand = rig.now + 1 + random() % 15'000;
            if (random() % 4 == 0) {
                rig.executor.slow_down();
            } else {
                rig.executor.set_feed_ratio(static_cast<double>(10 + random() % 191) / 100.0);
                rig.executor.go_on();
            }
        }
        const auto at = rig.pulses.positions();
        const std::int64_t now_ns = static_cast<std::int64_t>(rig.now) * period_ns;
        rig.tick();
        for (const Axis axis : kAllAxes) {
            const std::int64_t way = rig.pulses.positions()[index_of(axis)] - at[index_of(axis)];
            if (way != 0) rule.pulse(axis, way > 0, now_ns, {});
        }
    }
    ASSERT_NE(rig.seen & Executor::kProgramEnd, 0U);
    EXPECT_EQ(rig.pulses.positions(), program.points.back());
    rule.finish(static_cast<std::int64_t>(rig.now) * period_ns + 1'000'000'000);
    EXPECT_EQ(log.result(3).offences, 0U) << (log.result(3).first ? log.result(3).first->sentence : "");
}

class HardRests : public ::testing::TestWithParam<plan::test::HardMachine> {};

TEST_P(HardRests, OfProgramsAskNoMotorForTooMuchAtAnyOverride) {
    // With 17 each of the machines has a way for which there is no curve; with 12 and 21 some.
    std::vector<std::uint64_t> seeds{12, 17, 21};
    for (std::uint64_t seed = 22; test::is_long_run() && seed < 80; ++seed) seeds.push_back(seed);
    for (const std::uint64_t seed : seeds) {
        const Profile profile = small_steps_profile(GetParam(), 1.01);
        const MachineLimits limits = plan::machine_limits(profile);
        const auto program = plan::test::hard_ways(limits, seed, 100, profile.job.path_tolerance_mm);
        const std::vector<MotionBlock> blocks = hard_program_blocks(limits, program);
        expect_joints_of_rests(blocks, seed);
        for (const int percent : {100, 200, 0}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", override " + std::to_string(percent));
            ASSERT_NO_FATAL_FAILURE(expect_motors_follow(profile, limits, program, blocks, percent));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(On, HardRests, ::testing::ValuesIn(kRestingMachines),
                         [](const auto& one) { return std::string{one.param.name}; });

/// Of a table's layer that no corner asks for.
std::size_t rests_without_corner(const MachineLimits& limits, const JobTable& table) {
    const auto job = plan::test::job_of(table);
    plan::LookaheadProgram program(limits, job, {});
    std::size_t groups = 0;
    MotionBlock block;
    while (program.next(block)) groups += block.kind == BlockKind::path && block.group_blocks > 0 ? 1 : 0;
    return groups - plan::test::stops_of(limits, *job) - 1;
}

struct RestingTable {
    const char* name;
    plan::test::HardMachine machine;
    std::int64_t pulses_per_rev;
    double tolerance_pulses;
    std::uint64_t seed;
};

class RestingTables : public ::testing::TestWithParam<RestingTable> {};

TEST_P(RestingTables, ObeyTheFourRulesAtAnyOverride) {
    Profile profile = small_steps_profile(GetParam().machine, GetParam().tolerance_pulses);
    profile.psi.pulses_per_rev = GetParam().pulses_per_rev;
    profile.port.pins[index_of(Signal::estop)] = 15;
    const MachineLimits limits = plan::machine_limits(profile);
    JobTable table = plan::test::hard_table(limits, GetParam().seed);
    table.psi_sweep_pulses = static_cast<std::int32_t>(profile.psi.pulses_per_rev / 2);
    table.profile_toml = profile_to_toml(profile);
    ASSERT_GT(rests_without_corner(limits, table), 0U) << "another seed is wanted";
    std::mt19937_64 random{GetParam().seed};
    for (const bool is_overridden : {false, true}) {
        if (!is_overridden && !test::is_long_run()) continue;
        const Carved result = carved(profile, table, [&](cycle::MachineRig& rig) {
            if (!is_overridden || random() % 20'000 != 0) return;
            rig.ask(cycle::RequestKind::override, 0, 10 + random() % 191);
        });
        EXPECT_TRUE(result.report.ok) << verify::report_text(result.report);
        EXPECT_EQ(result.stalls, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(
    On, RestingTables,
    ::testing::Values(RestingTable{"fine_psi", plan::test::kHardMachines[0], 128'000, 20.0, 8},
                      RestingTable{"slow", plan::test::kHardMachines[4], 32'000, 1.01, 11}),
    [](const auto& one) { return std::string{one.param.name}; });

}  // namespace
}  // namespace psicarve::motion
