// SPDX-License-Identifier: GPL-3.0-or-later
// Groups that go on in the next one, which comes in time, late or much too late: judged by the pulses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "hmi/verify/motor_rule.hpp"
#include "rtcore/cycle/motion_block.hpp"
#include "tests/rtcore/cycle/path_rig.hpp"
#include "tests/rtcore/plan/program_blocks.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

using cycle::BlockKind;
using cycle::Executor;
using cycle::MotionBlock;
using plan::test::dense_program;
using plan::test::kStartPulses;

constexpr std::uint64_t kLongRest = 400;  // ticks without a pulse

/// Group by group; the last one has the program's end behind it.
std::vector<std::vector<MotionBlock>> fed_groups(const std::vector<MotionBlock>& blocks) {
    std::vector<std::vector<MotionBlock>> groups;
    for (const MotionBlock& block : blocks) {
        if (block.kind != BlockKind::path && block.kind != BlockKind::program_end) continue;
        if (block.group_blocks > 0) groups.emplace_back();
        groups.back().push_back(block);
    }
    return groups;
}

/// When a group comes, and what an operator does.
struct Course {
    bool is_late = false;       ///< groups come at random, else all at once
    bool is_disturbed = false;  ///< holds, resumes and overrides
    std::uint64_t seed = 0;
};

struct Outcome {
    std::vector<std::uint32_t> order;
    std::uint64_t ticks = 0;
    int rests = 0;  ///< at an end of what was queued
    std::uint64_t offences = 0;
    std::string first_offence;
};

class Feeder {
public:
    Feeder(const Profile& profile, const std::vector<std::vector<MotionBlock>>& groups, const Course& course)
        : groups_(groups),
          course_(course),
          random_(course.seed),
          limits_(plan::machine_limits(profile)),
          rig_(limits_.tick),
          rule_(profile, log_) {
        rig_.pulses.set_enables(0xF, 0);
        for (std::size_t k = 0; k < kAxisCount; ++k) rig_.pulses.set_position(k, kStartPulses[k]);
        end_ = kStartPulses;
        rule_.begin(kPeriod_ns);
    }

    Outcome run() {
        give();
        while (given_ < groups_.size() && !course_.is_late) give();
        while ((rig_.seen & Executor::kProgramEnd) == 0 && rig_.now < 20'000'000) {
            tick();
            if (given_ < groups_.size() && is_due()) give();
            if (course_.is_disturbed && rig_.now >= next_hand_) disturb();
            if ((rig_.seen & Executor::kStarved) != 0) break;
        }
        EXPECT_EQ(rig_.seen & Executor::kStarved, 0U) << "seed " << course_.seed;
        EXPECT_NE(rig_.seen & Executor::kProgramEnd, 0U) << "seed " << course_.seed;
        EXPECT_EQ(rig_.pulses.positions(), end_);
        rule_.finish(static_cast<std::int64_t>(rig_.now) * kPeriod_ns + kNsPerS);
        result_.offences = log_.result(3).offences;
        if (log_.result(3).first) result_.first_offence = log_.result(3).first->sentence;
        result_.ticks = rig_.now;
        for (const cycle::Iteration& iteration : rig_.iterations) result_.order.push_back(iteration.axes);
        return result_;
    }

private:
    static constexpr std::int64_t kPeriod_ns = 50'000;
    static constexpr std::int64_t kNsPerS = 1'000'000'000;

    void give() {
        const auto& group = groups_[given_++];
        for (const MotionBlock& block : group) {
            rig_.program.push_back(block);
            for (std::size_t k = 0; k < kAxisCount; ++k) end_[k] += block.delta_pulses[k];
        }
        // Somewhere in this group, or in every third once it has rested at its end for long.
        wants_rest_ = random_() % 3 == 0;
        due_line_ = program_line(group[random_() % group.size()]);
        if (random_() % 2 == 0) {
            const std::size_t before_end = std::min<std::size_t>(random_() % 60, group.size() - 1);
            due_line_ = program_line(group[group.size() - 1 - before_end]);
        }
    }
    bool is_due() {
        if (!wants_rest_) return rig_.executor.program_line() >= due_line_ || is_at_open_end();
        return is_at_open_end() && rig_.now - last_pulse_ > kLongRest;
    }
    bool is_at_open_end() {
        if (!rig_.executor.has_run_out()) return false;
        EXPECT_EQ(rig_.pulses.positions(), end_);
        if (last_rest_ != given_) ++result_.rests;
        last_rest_ = given_;
        return true;
    }
    void tick() {
        const auto before = rig_.pulses.positions();
        const std::int64_t now_ns = static_cast<std::int64_t>(rig_.now) * kPeriod_ns;
        rig_.tick();
        for (const Axis axis : kAllAxes) {
            const auto k = static_cast<std::size_t>(axis);
            const std::int64_t way = rig_.pulses.positions()[k] - before[k];
            if (way == 0) continue;
            rule_.pulse(axis, way > 0, now_ns, {});
            last_pulse_ = rig_.now;
        }
    }
    void disturb() {
        next_hand_ = rig_.now + 1 + random_() % 3000;
        const bool holds = random_() % 4 == 0;
        if (holds) return rig_.executor.slow_down();
        rig_.executor.set_feed_ratio(static_cast<double>(10 + random_() % 191) / 100.0);
        rig_.executor.go_on();
    }

    const std::vector<std::vector<MotionBlock>>& groups_;
    Course course_;
    std::mt19937_64 random_;
    plan::MachineLimits limits_;
    cycle::PathRig rig_;
    verify::OffenceLog log_;
    verify::MotorRule rule_;
    Outcome result_;
    std::size_t given_ = 0;
    plan::Pulses4 end_;
    bool wants_rest_ = false;
    std::uint64_t due_line_ = 0;
    std::uint64_t last_pulse_ = 0;
    std::uint64_t next_hand_ = 0;
    std::size_t last_rest_ = 0;
};

class OpenEnds : public ::testing::TestWithParam<unsigned> {};

/// How far the blocks' ways are ahead of what an axis can do at its top speed, over any stretch of them.
double pulses_too_far(const std::vector<std::vector<MotionBlock>>& groups, std::size_t axis,
                      double speed_pps) {
    double most = 0.0;
    double ahead = 0.0;
    for (const auto& group : groups) {
        for (const MotionBlock& block : group) {
            if (block.kind != BlockKind::path) continue;
            const cycle::PathTiming& path = block.path;
            const double seconds =
                2.0 * path.length / (std::sqrt(path.start_speed2[0]) + std::sqrt(path.end_speed2[0]));
            ahead += std::abs(static_cast<double>(block.delta_pulses[axis])) - speed_pps * seconds;
            ahead = std::max(ahead, 0.0);
            most = std::max(most, ahead);
        }
    }
    return most;
}

// Both ends of a stretch may be rounded by half a pulse.
TEST_P(OpenEnds, KeepEveryAxisWithinItsTopSpeedThroughout) {
    const plan::MachineLimits limits = plan::machine_limits(Profile{});
    for (std::uint64_t seed = 1; seed <= (test::is_thorough() ? 16U : 4U); ++seed) {
        const auto groups = fed_groups(plan::test::program_blocks(
            dense_program(seed, 3000, GetParam(), seed % 2 == 0 ? 20.0 : 6.0).steps));
        for (std::size_t k = 0; k < kAxisCount; ++k)
            EXPECT_LE(pulses_too_far(groups, k, limits.axes[k].speed_pps), 1.0)
                << "seed " << seed << ", axis " << k;
    }
}

TEST_P(OpenEnds, RestWhereNothingIsQueuedAndNoMotorIsAskedForTooMuch) {
    const Profile profile;
    const std::uint64_t seeds = test::is_long_run() ? 60 : test::is_thorough() ? 16 : 4;
    int rests = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const double step = seed % 2 == 0 ? 20.0 : 6.0;
        const auto groups =
            fed_groups(plan::test::program_blocks(dense_program(seed, 3000, GetParam(), step).steps));
        ASSERT_GE(groups.size(), 5U);
        const Outcome plain = Feeder(profile, groups, {}).run();
        EXPECT_EQ(plain.rests, 0);
        EXPECT_EQ(plain.offences, 0U) << plain.first_offence;
        for (const bool is_disturbed : {false, true}) {
            const Outcome late = Feeder(profile, groups, {true, is_disturbed, seed}).run();
            EXPECT_EQ(late.order, plain.order) << "seed " << seed;
            EXPECT_EQ(late.offences, 0U) << "seed " << seed << ": " << late.first_offence;
            rests += late.rests;
        }
    }
    EXPECT_GT(rests, 0);
}

INSTANTIATE_TEST_SUITE_P(Axes, OpenEnds, ::testing::Values(0b0101U, 0b1001U, 0b1101U, 0b1111U));

// Corners that ask for a rest, and long ways with points of their own, wherever parts begin and end.
TEST(OpenEnd, RestsAmongCornersAndLongWaysToo) {
    const Profile profile;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        plan::test::Script script = dense_program(seed, 3000, 0b1101, 6.0);
        std::mt19937_64 random{seed};
        plan::Pulses4 off{};
        for (std::size_t i = 0; i + 1 < script.steps.size(); ++i) {
            const std::uint64_t kind = random() % 400;
            if (kind == 0) off[0] += 300;
            if (kind == 1) off[kPsi] -= 900;
            if (kind == 2) off[kPsi] += 40;
            for (std::size_t k = 0; k < kAxisCount; ++k) script.steps[i].target_pulses[k] += off[k];
        }
        const auto groups = fed_groups(plan::test::program_blocks(script.steps));
        const Outcome plain = Feeder(profile, groups, {}).run();
        EXPECT_EQ(plain.offences, 0U) << plain.first_offence;
        const Outcome late = Feeder(profile, groups, {true, true, seed}).run();
        EXPECT_EQ(late.order, plain.order) << "seed " << seed;
        EXPECT_EQ(late.offences, 0U) << "seed " << seed << ": " << late.first_offence;
    }
}

// Nothing that is asked for changes a pulse's time if all is there before the cap would bite.
TEST(OpenEnd, ThatGoesOnInTimeShowsInNoPulse) {
    const auto groups = fed_groups(plan::test::program_blocks(dense_program(3, 3000, 0b1101).steps));
    const auto pulses_of = [&](bool all_at_once) {
        cycle::PathRig rig{plan::machine_limits(Profile{}).tick};
        rig.pulses.set_enables(0xF, 0);
        std::size_t given = 0;
        const auto give = [&] {
            rig.program.insert(rig.program.end(), groups[given].begin(), groups[given].end());
            ++given;
        };
        give();
        while (all_at_once && given < groups.size()) give();
        while ((rig.seen & Executor::kProgramEnd) == 0 && rig.now < 5'000'000) {
            if (given < groups.size() && (rig.executor.runs_short() || rig.executor.has_run_out())) give();
            rig.tick();
        }
        std::vector<std::uint64_t> ticks;
        for (const cycle::Iteration& iteration : rig.iterations) ticks.push_back(iteration.tick);
        return ticks;
    };
    EXPECT_EQ(pulses_of(true), pulses_of(false));
}

}  // namespace
}  // namespace psicarve::motion
