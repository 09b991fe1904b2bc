// SPDX-License-Identifier: GPL-3.0-or-later
// Programs while an operator turns at both overrides and holds: judged by the pulses.
#include <gtest/gtest.h>

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
using cycle::WayKind;
using plan::test::dense_program;
using plan::test::kStartPulses;
using plan::test::Script;

constexpr std::int64_t kPeriod_ns = 50'000;

std::vector<MotionBlock> moving_blocks(const std::vector<plan::ProgramStep>& steps) {
    std::vector<MotionBlock> moving;
    for (const MotionBlock& block : plan::test::program_blocks(steps)) {
        if (block.kind == BlockKind::path || block.kind == BlockKind::program_end) moving.push_back(block);
    }
    return moving;
}

/// Runs of rapid ways in a dense program, which itself has none.
Script with_rapids(Script script, std::uint64_t seed) {
    std::mt19937_64 random{seed};
    std::size_t left = 0;
    bool is_rapid = false;
    for (plan::ProgramStep& step : script.steps) {
        if (step.kind != MotionKind::way) continue;
        if (left == 0) {
            is_rapid = !is_rapid;
            left = 1 + random() % (random() % 4 == 0 ? 400 : 30);
        }
        --left;
        step.is_rapid = is_rapid;
        step.seconds = is_rapid ? 0.0 : 0.001 * static_cast<double>(1 + random() % 8);
    }
    return script;
}

struct Outcome {
    std::vector<std::uint32_t> order;
    std::vector<std::uint64_t> line_ticks;  ///< by line: how many ticks it was at hand
    std::vector<std::uint64_t> rests;       ///< by line, at its end
    std::uint64_t ticks = 0;
    std::uint64_t offences = 0;
    std::string first_offence;
};

class Machine {
public:
    explicit Machine(const std::vector<MotionBlock>& blocks)
        : limits_(plan::machine_limits(profile_)), rig_(limits_.tick), rule_(profile_, log_) {
        rig_.pulses.set_enables(0xF, 0);
        for (std::size_t k = 0; k < kAxisCount; ++k) rig_.pulses.set_position(k, kStartPulses[k]);
        rig_.program = blocks;
        end_ = kStartPulses;
        for (const MotionBlock& block : blocks) {
            for (std::size_t k = 0; k < kAxisCount; ++k) end_[k] += block.delta_pulses[k];
        }
        rule_.begin(kPeriod_ns);
    }

    /// `hand` may do what it likes before each tick.
    template <typename Hand>
    Outcome run(Hand&& hand) {
        while ((rig_.seen & (Executor::kProgramEnd | Executor::kStarved)) == 0 && rig_.now < 40'000'000) {
            hand(rig_);
            const Executor::Progress progress = tick();
            if ((progress & Executor::kLineDone) == 0) continue;
            result_.rests.push_back(rig_.executor.program_line());
            rig_.executor.go_on();
        }
        EXPECT_NE(rig_.seen & Executor::kProgramEnd, 0U);
        EXPECT_EQ(rig_.pulses.positions(), end_);
        rule_.finish(static_cast<std::int64_t>(rig_.now) * kPeriod_ns + 1'000'000'000);
        result_.offences = log_.result(3).offences;
        if (log_.result(3).first) result_.first_offence = log_.result(3).first->sentence;
        result_.ticks = rig_.now;
        for (const cycle::Iteration& iteration : rig_.iterations) result_.order.push_back(iteration.axes);
        return result_;
    }

private:
    Executor::Progress tick() {
        const auto before = rig_.pulses.positions();
        const std::int64_t now_ns = static_cast<std::int64_t>(rig_.now) * kPeriod_ns;
        const Executor::Progress progress = rig_.tick();
        const std::uint64_t line = rig_.executor.program_line();
        if (line >= result_.line_ticks.size()) result_.line_ticks.resize(line + 1);
        ++result_.line_ticks[line];
        for (const Axis axis : kAllAxes) {
            const std::int64_t way = rig_.pulses.positions()[index_of(axis)] - before[index_of(axis)];
            if (way != 0) rule_.pulse(axis, way > 0, now_ns, {});
        }
        return progress;
    }

    Profile profile_;
    plan::MachineLimits limits_;
    cycle::PathRig rig_;
    verify::OffenceLog log_;
    verify::MotorRule rule_;
    plan::Pulses4 end_;
    Outcome result_;
};

Outcome with_overrides(const std::vector<MotionBlock>& blocks, double feed_ratio, double rapid_ratio) {
    return Machine(blocks).run([&](cycle::PathRig& rig) {
        if (rig.now != 0) return;
        rig.executor.set_feed_ratio(feed_ratio);
        rig.executor.set_rapid_ratio(rapid_ratio);
    });
}

constexpr std::uint64_t kIn = 1;
constexpr std::uint64_t kAway = 2;
constexpr std::uint64_t kOut = 3;

/// A rapid way, a way in the material that goes on, a rapid way.
std::vector<MotionBlock> in_and_out() {
    Script script{kStartPulses};
    script.way({0, 0, 4000, 0}, 0.02, 0.0, true).way({0, 0, 1500, 0}, 0.02, 0.6);
    script.way({0, 0, 4000, 0}, 0.02, 0.0, true).end();
    return moving_blocks(script.steps);
}

TEST(RapidOverride, IsForRapidWaysAloneAndTheFeedsIsNot) {
    const auto blocks = in_and_out();
    const Outcome plain = with_overrides(blocks, 1.0, 1.0);
    const auto ratio = [&](const Outcome& outcome, std::uint64_t line) {
        return static_cast<double>(outcome.line_ticks[line]) / static_cast<double>(plain.line_ticks[line]);
    };
    const Outcome slow_rapids = with_overrides(blocks, 1.0, 0.25);
    EXPECT_GT(ratio(slow_rapids, kIn), 2.5);
    EXPECT_GT(ratio(slow_rapids, kOut), 2.5);
    EXPECT_NEAR(ratio(slow_rapids, kAway), 1.0, 0.05);
    const Outcome slow_feed = with_overrides(blocks, 0.25, 1.0);
    EXPECT_NEAR(ratio(slow_feed, kAway), 4.0, 0.1);
    EXPECT_LT(ratio(slow_feed, kIn), 1.5);
    EXPECT_LT(ratio(slow_feed, kOut), 1.1);
    const Outcome fast_feed = with_overrides(blocks, 2.0, 0.5);
    EXPECT_LT(ratio(fast_feed, kAway), 0.7);
    EXPECT_GT(ratio(fast_feed, kIn), 1.5);
    for (const Outcome& outcome : {slow_rapids, slow_feed, fast_feed}) {
        EXPECT_EQ(outcome.order, plain.order);
        EXPECT_EQ(outcome.offences, 0U) << outcome.first_offence;
    }
}

// The tool comes to the material no faster than it is to go there.
TEST(RapidOverride, SlowsDownBeforeAWayInTheMaterial) {
    const auto blocks = in_and_out();
    const std::uint64_t plain_ticks = with_overrides(blocks, 1.0, 1.0).line_ticks[kAway];
    for (const double feed_ratio : {0.1, 0.3, 0.8}) {
        std::vector<std::uint64_t> ticks;
        Machine(blocks).run([&](cycle::PathRig& rig) {
            if (rig.now == 0) rig.executor.set_feed_ratio(feed_ratio);
            if (rig.executor.program_line() == kAway && ticks.size() < 20 && !rig.iterations.empty() &&
                (ticks.empty() || rig.iterations.back().tick > ticks.back()))
                ticks.push_back(rig.iterations.back().tick);
        });
        ASSERT_EQ(ticks.size(), 20U);
        const double apart = static_cast<double>(ticks.back() - ticks[1]) / 18.0;
        const double planned = static_cast<double>(plain_ticks) / 1500.0 / feed_ratio;
        EXPECT_GT(apart, 0.9 * planned) << "at " << feed_ratio;
    }
}

TEST(RapidOverride, AsksNoMotorForTooMuchWhateverIsTurnedAtAndWhen) {
    const std::uint64_t seeds = test::is_long_run() ? 60 : test::is_thorough() ? 12 : 3;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const unsigned axes = seed % 3 == 0 ? 0b1111U : seed % 3 == 1 ? 0b1101U : 0b0101U;
        const double step = seed % 2 == 0 ? 20.0 : 6.0;
        const auto blocks = moving_blocks(with_rapids(dense_program(seed, 2000, axes, step), seed).steps);
        const auto plain = with_overrides(blocks, 1.0, 1.0);
        EXPECT_EQ(plain.offences, 0U) << plain.first_offence;
        std::mt19937_64 random{seed};
        std::uint64_t next_tick = 0;
        const Outcome turned = Machine(blocks).run([&](cycle::PathRig& rig) {
            if (rig.now < next_tick) return;
            next_tick = rig.now + 1 + random() % 1500;
            if (random() % 5 == 0) return rig.executor.slow_down();
            rig.executor.set_feed_ratio(static_cast<double>(10 + random() % 191) / 100.0);
            rig.executor.set_rapid_ratio(static_cast<double>(10 + random() % 91) / 100.0);
            rig.executor.go_on();
        });
        EXPECT_EQ(turned.order, plain.order) << "seed " << seed;
        EXPECT_EQ(turned.offences, 0U) << "seed " << seed << ": " << turned.first_offence;
    }
}

// Blended or not: at the end of every line, on the pulses that it has then.
TEST(SingleBlock, RestsWhereEachLineEnds) {
    for (const double tolerance_mm : {0.02, 0.0}) {
        Script script{kStartPulses};
        for (int i = 0; i < 12; ++i)
            script.way({i % 3 == 0 ? 300 : 0, 0, 200 + 40 * i, i % 4 == 0 ? 0 : -30}, tolerance_mm, 0.02);
        script.way({0, 0, 6, 0}, tolerance_mm)
            .way({0, 0, 5, 2}, tolerance_mm)
            .way({0, 0, 4, 0}, tolerance_mm);
        script.dwell(0.01).spindle(true).end();
        const auto blocks = moving_blocks(script.steps);
        const Outcome plain = with_overrides(blocks, 1.0, 1.0);
        EXPECT_TRUE(plain.rests.empty());
        const Outcome single = Machine(blocks).run([](cycle::PathRig& rig) {
            if (rig.now == 0) rig.executor.rest_behind(cycle::kEndsLine);
        });
        std::vector<std::uint64_t> lines(15);
        for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = i + 1;
        EXPECT_EQ(single.rests, lines) << "P " << tolerance_mm;
        EXPECT_EQ(single.order, plain.order);
        EXPECT_EQ(single.offences, 0U) << single.first_offence;
    }
}

TEST(SingleBlock, AsksNoMotorForTooMuchWheneverItIsSwitched) {
    const std::uint64_t seeds = test::is_long_run() ? 60 : test::is_thorough() ? 12 : 4;
    std::size_t rests = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const unsigned axes = seed % 3 == 0 ? 0b1111U : seed % 3 == 1 ? 0b1101U : 0b0101U;
        const double step = seed % 2 == 0 ? 20.0 : 6.0;
        const auto blocks = moving_blocks(with_rapids(dense_program(seed, 2000, axes, step), seed).steps);
        const auto plain = with_overrides(blocks, 1.0, 1.0);
        std::mt19937_64 random{seed};
        std::uint64_t next_tick = 0;
        const Outcome switched = Machine(blocks).run([&](cycle::PathRig& rig) {
            if (rig.now < next_tick) return;
            next_tick = rig.now + 1 + random() % 1500;
            rig.executor.rest_behind(random() % 2 == 0 ? cycle::kEndsLine : 0);
            if (random() % 8 == 0) return rig.executor.slow_down();
            rig.executor.set_feed_ratio(static_cast<double>(10 + random() % 191) / 100.0);
            rig.executor.set_rapid_ratio(static_cast<double>(10 + random() % 91) / 100.0);
            rig.executor.go_on();
        });
        EXPECT_EQ(switched.order, plain.order) << "seed " << seed;
        EXPECT_EQ(switched.offences, 0U) << "seed " << seed << ": " << switched.first_offence;
        rests += switched.rests.size();
    }
    EXPECT_GT(rests, 50 * seeds);
}

}  // namespace
}  // namespace psicarve::motion
