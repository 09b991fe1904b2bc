// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/program/record_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "rtcore/cycle/dual_head_dda.hpp"
#include "rtcore/cycle/soft_limits.hpp"
#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "shared/base/units.hpp"
#include "shared/wording/wording.hpp"
#include "tests/rtcore/program/program_in_memory.hpp"

namespace psicarve::program {
namespace {

using plan::ProgramStep;
using plan::Pulses4;
using test::positions;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

MotionRecord way_to(std::uint8_t axes, std::array<double, kAxisCount> target) {
    MotionRecord record{};
    record.line = 12;
    record.kind = MotionKind::way;
    record.axes = axes;
    record.target = target;
    return record;
}
MotionRecord of_kind(MotionKind kind, std::uint8_t code = 0) {
    MotionRecord record{};
    record.line = 12;
    record.kind = kind;
    record.code = code;
    return record;
}
constexpr std::uint8_t bit(Axis axis) {
    return static_cast<std::uint8_t>(1U << index_of(axis));
}
constexpr std::uint8_t kHeadBits = bit(Axis::r1) | bit(Axis::r2);

class RecordRulesTest : public testing::Test {
protected:
    MessageId judge(const MotionRecord& record) {
        const Message said = RecordRules{profile_}.judge(record, at_, step_);
        if (!said.is_none()) {
            EXPECT_TRUE(is_sound(said)) << static_cast<int>(said.id);
            EXPECT_EQ(said.arguments[0].bits, record.line) << "the line comes first";
        }
        return said.id;
    }
    /// The same with one thing changed.
    MessageId judge(MotionRecord record, const std::function<void(MotionRecord&)>& change) {
        change(record);
        return judge(record);
    }
    Profile profile_;
    Pulses4 at_ = test::middle_of(profile_);
    ProgramStep step_;
    MotionRecord good_ = way_to(0xF, positions(20.0, 25.0, 30.0, 720.0));
};

TEST_F(RecordRulesTest, AWayBecomesPulsesOfTheAxesThatItNames) {
    MotionRecord record = way_to(bit(Axis::r2) | bit(Axis::psi), positions(99.0, 25.0026, 99.0, -90.0));
    record.flags = kIsRapid | kEndsBlock;
    record.seconds = 1.5;
    record.tolerance_mm = 0.02;

    ASSERT_EQ(judge(record), MessageId::none);

    EXPECT_EQ(step_.kind, MotionKind::way);
    EXPECT_TRUE(step_.is_rapid && step_.ends_block);
    EXPECT_EQ(step_.line, 12U);
    EXPECT_EQ(step_.seconds, 1.5);
    EXPECT_EQ(step_.tolerance_mm, 0.02);
    Pulses4 wanted = at_;
    wanted[index_of(Axis::r2)] = 10'001;
    wanted[index_of(Axis::psi)] = -1'600;
    EXPECT_EQ(step_.target_pulses, wanted);
}

TEST_F(RecordRulesTest, AWayThatGoesNowhereIsAStepToTheSamePlace) {
    ASSERT_EQ(judge(way_to(0, {})), MessageId::none);
    EXPECT_EQ(step_.target_pulses, at_);
    ASSERT_EQ(judge(way_to(bit(Axis::y), positions(0.0, 0.0, 75.001, 0.0))), MessageId::none);
    EXPECT_EQ(step_.target_pulses, at_);
}

TEST_F(RecordRulesTest, OtherKindsBecomeStepsWhereTheMachineStands) {
    MotionRecord dwell = of_kind(MotionKind::dwell);
    dwell.seconds = 2.5;
    ASSERT_EQ(judge(dwell), MessageId::none);
    EXPECT_EQ(step_.seconds, 2.5);
    EXPECT_EQ(step_.target_pulses, at_);
    ASSERT_EQ(judge(of_kind(MotionKind::spindle, 1)), MessageId::none);
    EXPECT_TRUE(step_.is_on);
    ASSERT_EQ(judge(of_kind(MotionKind::spindle, 0)), MessageId::none);
    EXPECT_FALSE(step_.is_on);
    profile_.port.pins[index_of(Signal::r2_enable)] = 6;
    profile_.port.pins[index_of(Signal::flood)] = 7;
    MotionRecord flood = of_kind(MotionKind::output, 1);
    flood.outputs = switched_bit(Signal::flood);
    ASSERT_EQ(judge(flood), MessageId::none);
    EXPECT_TRUE(step_.is_on);
    EXPECT_EQ(step_.outputs, switched_bit(Signal::flood));
    EXPECT_EQ(step_.target_pulses, at_);
    flood.code = 0;
    ASSERT_EQ(judge(flood), MessageId::none);
    EXPECT_FALSE(step_.is_on);
    ASSERT_EQ(judge(of_kind(MotionKind::stop, 3)), MessageId::none);
    EXPECT_EQ(step_.reason, StopReason::tool_change);
    ASSERT_EQ(judge(of_kind(MotionKind::end)), MessageId::none);
    EXPECT_EQ(step_.kind, MotionKind::end);
}

TEST_F(RecordRulesTest, OutputsThatAreNotWiredAreRefusedByTheirName) {
    MotionRecord output = of_kind(MotionKind::output, 1);
    for (std::size_t k = kFirstSwitchedOutput; k < kSignalCount; ++k) {
        const auto signal = static_cast<Signal>(k);
        output.outputs = switched_bit(signal);
        ASSERT_EQ(judge(output), MessageId::program_output_not_wired);
        const Message said = RecordRules{profile_}.judge(output, at_, step_);
        EXPECT_TRUE(in_words(said).starts_with("line 12: " + std::string{name_of(signal)} +
                                               " is not wired to any pin"));
    }
    profile_.port.pins[index_of(Signal::r2_enable)] = 6;
    profile_.port.pins[index_of(Signal::flood)] = 7;
    output.outputs = kAllSwitchedOutputs;
    EXPECT_EQ(judge(output), MessageId::program_output_not_wired) << "not even those that are";
    for (const unsigned outputs : {0U, 64U, 128U, 66U}) {
        output.outputs = static_cast<SwitchedOutputs>(outputs);
        EXPECT_EQ(judge(output), MessageId::program_record_unknown) << outputs;
    }
    output.outputs = switched_bit(Signal::flood);
    output.code = 2;
    EXPECT_EQ(judge(output), MessageId::program_record_unknown);
    for (const MotionKind kind :
         {MotionKind::dwell, MotionKind::spindle, MotionKind::end, MotionKind::way, MotionKind::arc}) {
        MotionRecord other = of_kind(kind);
        other.outputs = switched_bit(Signal::flood);
        EXPECT_EQ(judge(other), MessageId::program_record_unknown);
    }
}

TEST_F(RecordRulesTest, WhatIsNotKnownIsRefused) {
    const auto expect_unknown = [&](const MotionRecord& record,
                                    const std::function<void(MotionRecord&)>& how) {
        EXPECT_EQ(judge(record, how), MessageId::program_record_unknown);
    };
    for (const int kind : {0, 6, 7, 8, 255})
        expect_unknown(good_, [&](MotionRecord& r) { r.kind = static_cast<MotionKind>(kind); });
    for (unsigned flag = 4; flag < 256; flag *= 2)
        expect_unknown(good_, [&](MotionRecord& r) { r.flags = static_cast<std::uint8_t>(flag); });
    for (std::size_t i = 0; i < 3; ++i) expect_unknown(good_, [&](MotionRecord& r) { r.reserved[i] = 1; });
    for (const unsigned axes : {16U, 128U})
        expect_unknown(good_, [&](MotionRecord& r) { r.axes = static_cast<std::uint8_t>(axes); });
    expect_unknown(good_, [](MotionRecord& r) { r.code = 1; });
    expect_unknown(of_kind(MotionKind::spindle, 2), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::stop, 0), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::stop, 6), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::stop, 255), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::dwell, 1), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::end, 1), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::end), [](MotionRecord& r) { r.axes = 1; });
    expect_unknown(of_kind(MotionKind::dwell), [](MotionRecord& r) { r.flags = kIsRapid; });
    MotionRecord without_line = good_;
    without_line.line = 0;
    EXPECT_EQ(judge(without_line), MessageId::program_record_unknown);
}

TEST_F(RecordRulesTest, EachReasonToStopIsTaken) {
    for (const StopReason reason : {StopReason::program, StopReason::optional, StopReason::tool_change,
                                    StopReason::optional_at_rest, StopReason::optional_on_way})
        EXPECT_EQ(judge(of_kind(MotionKind::stop, static_cast<std::uint8_t>(reason))), MessageId::none);
}

TEST_F(RecordRulesTest, NumbersThatAreNoneAreRefused) {
    for (const double none : {kNan, kInfinity, -kInfinity}) {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            EXPECT_EQ(judge(good_, [&](MotionRecord& r) { r.target[k] = none; }),
                      MessageId::program_number_not_finite);
        }
        EXPECT_EQ(judge(good_, [&](MotionRecord& r) { r.seconds = none; }),
                  MessageId::program_number_not_finite);
        EXPECT_EQ(judge(good_, [&](MotionRecord& r) { r.tolerance_mm = none; }),
                  MessageId::program_number_not_finite);
    }
}

TEST_F(RecordRulesTest, TimesAndTolerancesHaveTheirBounds) {
    for (const MotionRecord& record : {good_, of_kind(MotionKind::dwell)}) {
        EXPECT_EQ(judge(record, [](MotionRecord& r) { r.seconds = kMostSeconds; }), MessageId::none);
        for (const double wrong : {-1e-9, kMostSeconds * 1.000001, 1e300}) {
            EXPECT_EQ(judge(record, [&](MotionRecord& r) { r.seconds = wrong; }),
                      MessageId::program_time_out_of_range);
        }
    }
    EXPECT_EQ(judge(good_, [](MotionRecord& r) { r.tolerance_mm = kMostTolerance_mm; }), MessageId::none);
    for (const double wrong : {-1e-9, 1000.1, 1e300}) {
        EXPECT_EQ(judge(good_, [&](MotionRecord& r) { r.tolerance_mm = wrong; }),
                  MessageId::program_tolerance_out_of_range);
    }
}

TEST_F(RecordRulesTest, EveryAxisEndsWithinItsTravelToThePulse) {
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
        const AxisMotion motion = axis_motion(profile_, axis);
        const double pulse_mm = 1.0 / motion.pulses_per_unit;
        const double last_mm = static_cast<double>(motion.travel_max_pulses) * pulse_mm;
        std::array<double, kAxisCount> target{};
        target[index_of(axis)] = last_mm + 0.4 * pulse_mm;
        EXPECT_EQ(judge(way_to(bit(axis), target)), MessageId::none);
        target[index_of(axis)] = last_mm + 0.6 * pulse_mm;
        EXPECT_EQ(judge(way_to(bit(axis), target)), MessageId::program_outside_travel);
    }
    EXPECT_EQ(judge(way_to(bit(Axis::y), positions(0.0, 0.0, -0.002, 0.0))),
              MessageId::program_outside_travel);
    EXPECT_EQ(judge(way_to(bit(Axis::y), positions(0.0, 0.0, 0.0, 0.0))), MessageId::none);
    // It does not matter what a number says of an axis that the record does not name.
    EXPECT_EQ(judge(way_to(bit(Axis::y), positions(1e300, -5.0, 10.0, 1e300))), MessageId::none);
}

TEST_F(RecordRulesTest, PsiTurnsAsFarAsItCanBeCounted) {
    EXPECT_EQ(judge(way_to(bit(Axis::psi), positions(0.0, 0.0, 0.0, 3.8e9))), MessageId::none);
    EXPECT_EQ(judge(way_to(bit(Axis::psi), positions(0.0, 0.0, 0.0, 3.9e9))),
              MessageId::program_cannot_count_so_far);
    EXPECT_EQ(judge(way_to(bit(Axis::psi), positions(0.0, 0.0, 0.0, -1e308))),
              MessageId::program_cannot_count_so_far);
    EXPECT_EQ(judge(way_to(bit(Axis::r1), positions(1e308, 0.0, 0.0, 0.0))),
              MessageId::program_cannot_count_so_far);
}

TEST_F(RecordRulesTest, NoHeadComesIntoTheCore) {
    for (const Axis head : {Axis::r1, Axis::r2}) {
        std::array<double, kAxisCount> target{};
        target[index_of(head)] = profile_.core_radius_mm;
        EXPECT_EQ(judge(way_to(bit(head), target)), MessageId::none);
        target[index_of(head)] = profile_.core_radius_mm - 0.002;
        EXPECT_EQ(judge(way_to(bit(head), target)), MessageId::program_inside_core_radius);
    }
    profile_.r1.tip_offset_mm = 0.5;
    EXPECT_EQ(judge(way_to(bit(Axis::r1), positions(1.0, 0.0, 0.0, 0.0))), MessageId::none);
    EXPECT_EQ(judge(way_to(bit(Axis::r1), positions(0.997, 0.0, 0.0, 0.0))),
              MessageId::program_inside_core_radius);
}

class RecordRulesOfTips : public RecordRulesTest {
protected:
    void SetUp() override {
        profile_.head_clearance_mm = 8.0;
        profile_.r1.tip_offset_mm = 0.25;
    }
    void stand_at(double r1_mm, double r2_mm) {
        at_[0] = pulses_from_mm(r1_mm, profile_.r1.pulses_per_mm);
        at_[1] = pulses_from_mm(r2_mm, profile_.r2.pulses_per_mm);
    }
};

TEST_F(RecordRulesOfTips, KeepTheClearanceLessTheRoundingOfTwoRadii) {
    EXPECT_EQ(judge(way_to(kHeadBits, positions(4.0, 3.75, 0.0, 0.0))), MessageId::none);
    EXPECT_EQ(judge(way_to(kHeadBits, positions(4.0, 3.7475, 0.0, 0.0))), MessageId::none)
        << "half a pulse each";
    EXPECT_EQ(judge(way_to(kHeadBits, positions(4.0, 3.745, 0.0, 0.0))), MessageId::program_tips_too_close);
}

TEST_F(RecordRulesOfTips, AreJudgedWhereOneHeadMovesAlone) {
    stand_at(4.0, 30.0);
    EXPECT_EQ(judge(way_to(bit(Axis::r2), positions(0.0, 3.745, 0.0, 0.0))),
              MessageId::program_tips_too_close);
}

TEST_F(RecordRulesOfTips, AreNotJudgedWhereNoHeadMoves) {
    stand_at(2.0, 2.0);
    EXPECT_EQ(judge(way_to(bit(Axis::y), positions(0.0, 0.0, 20.0, 0.0))), MessageId::none);
    EXPECT_EQ(judge(way_to(bit(Axis::r1), positions(2.0, 0.0, 0.0, 0.0))), MessageId::none)
        << "it goes nowhere";
    EXPECT_EQ(judge(way_to(bit(Axis::r1), positions(2.1, 0.0, 0.0, 0.0))), MessageId::program_tips_too_close);
    EXPECT_EQ(judge(way_to(bit(Axis::r1), positions(20.0, 0.0, 0.0, 0.0))), MessageId::none)
        << "it leads out of it";
}

TEST_F(RecordRulesOfTips, HaveAPulseMoreWhereOneHeadGoesInAndTheOtherOut) {
    stand_at(4.0, 3.75);
    EXPECT_EQ(judge(way_to(kHeadBits, positions(2.0, 5.75, 0.0, 0.0))), MessageId::none)
        << "to the clearance itself";
    stand_at(4.0, 3.7475);
    EXPECT_EQ(judge(way_to(kHeadBits, positions(2.0, 6.0, 0.0, 0.0))),
              MessageId::program_tips_pass_too_close);
    EXPECT_EQ(judge(way_to(kHeadBits, positions(4.5, 4.0, 0.0, 0.0))), MessageId::none) << "both go out";
}

/// Each pulse of an accepted way, against limits that are computed for moves by hand.
void walk(const cycle::SoftLimits& limits, const Pulses4& from, const Pulses4& to, int round) {
    Pulses4 delta{};
    for (std::size_t k = 0; k < kAxisCount; ++k) delta[k] = to[k] - from[k];
    cycle::DualHeadDda dda;
    dda.start(delta);
    Pulses4 at = from;
    while (dda.iterations_left() > 0) {
        const std::uint32_t mask = dda.iterate();
        for (std::size_t k = 0; k < kAxisCount; ++k)
            if ((mask >> k & 1U) != 0) at[k] += delta[k] < 0 ? -1 : 1;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            ASSERT_GE(at[k], limits.least_pulses[k]) << round;
            ASSERT_LE(at[k], limits.most_pulses[k]) << round;
        }
        ASSERT_GE(at[0], limits.core_pulses[0]) << round;
        ASSERT_GE(at[1], limits.core_pulses[1]) << round;
        const double sum_mm = static_cast<double>(at[0]) * limits.mm_per_pulse[0] +
                              static_cast<double>(at[1]) * limits.mm_per_pulse[1];
        ASSERT_GE(sum_mm, limits.least_sum_mm - 1e-9) << round;
    }
    ASSERT_EQ(at, to);
}

TEST(RecordRulesSweep, NoPulseOfAGoodWayBreaksALimitAndTheRestIsRefused) {
    std::mt19937 random{20261127};
    const auto between = [&](double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(random);
    };
    int good = 0;
    int refused = 0;
    int narrow = 0;
    for (int round = 0; round < 20'000; ++round) {
        Profile profile;
        profile.r1.pulses_per_mm = random() % 2 == 0 ? 40.0 : 33.3;
        profile.r2.pulses_per_mm = random() % 2 == 0 ? 40.0 : 57.7;
        profile.y.pulses_per_mm = 20.0;
        profile.head_clearance_mm = between(4.0, 9.0);
        profile.r1.tip_offset_mm = between(-0.2, 0.2);
        const cycle::SoftLimits limits = plan::cycle_config_from_profile(profile).soft_limits;
        const RecordRules rules{profile};
        Pulses4 at = test::middle_of(profile);
        ProgramStep step;
        for (int i = 0; i < 2; ++i) {
            MotionRecord record = way_to(static_cast<std::uint8_t>(random() % 16), {});
            record.target = positions(between(-1.0, 12.0), between(-1.0, 12.0), between(-2.0, 152.0),
                                      between(-40.0, 40.0));
            // Often as near to each other as they may.
            if (random() % 2 == 0) {
                record.target[1] =
                    profile.head_clearance_mm - profile.r1.tip_mm() - record.target[0] + between(-0.03, 0.03);
                ++narrow;
            }
            const Message said = rules.judge(record, at, step);
            const bool is_axis_out = [&] {
                for (const std::size_t k : {index_of(Axis::r1), index_of(Axis::r2), index_of(Axis::y)}) {
                    const double scale = axis_motion(profile, static_cast<Axis>(k)).pulses_per_unit;
                    const std::int64_t to = pulses_from_mm(record.target[k], scale);
                    const bool is_core = k < 2 && to < limits.core_pulses[k];
                    if ((record.axes >> k & 1U) != 0 &&
                        (to < limits.least_pulses[k] || to > limits.most_pulses[k] || is_core))
                        return true;
                }
                return false;
            }();
            if (said.is_none()) {
                ++good;
                ASSERT_FALSE(is_axis_out) << round;
                walk(limits, at, step.target_pulses, round);
                if (testing::Test::HasFatalFailure()) return;
                at = step.target_pulses;
                continue;
            }
            ++refused;
            const bool is_about_axis = said.id == MessageId::program_outside_travel ||
                                       said.id == MessageId::program_inside_core_radius;
            ASSERT_EQ(is_about_axis, is_axis_out) << round << ": " << in_words(said);
        }
    }
    EXPECT_GT(good, 5'000);
    EXPECT_GT(refused, 5'000);
    EXPECT_GT(narrow, 5'000);
}

}  // namespace
}  // namespace psicarve::program
