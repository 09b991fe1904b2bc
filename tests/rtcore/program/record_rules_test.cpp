// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/program/record_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "rtcore/cycle/arc_order.hpp"
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
constexpr std::size_t kYAt = index_of(Axis::y);

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
    EXPECT_TRUE(step_.is_spindle_on);
    ASSERT_EQ(judge(of_kind(MotionKind::spindle, 0)), MessageId::none);
    EXPECT_FALSE(step_.is_spindle_on);
    ASSERT_EQ(judge(of_kind(MotionKind::stop, 3)), MessageId::none);
    EXPECT_EQ(step_.reason, StopReason::tool_change);
    ASSERT_EQ(judge(of_kind(MotionKind::end)), MessageId::none);
    EXPECT_EQ(step_.kind, MotionKind::end);
}

TEST_F(RecordRulesTest, WhatIsNotKnownIsRefused) {
    const auto expect_unknown = [&](const MotionRecord& record,
                                    const std::function<void(MotionRecord&)>& how) {
        EXPECT_EQ(judge(record, how), MessageId::program_record_unknown);
    };
    for (const int kind : {0, 6, 255})
        expect_unknown(good_, [&](MotionRecord& r) { r.kind = static_cast<MotionKind>(kind); });
    for (unsigned flag = 4; flag < 256; flag *= 2)
        expect_unknown(good_, [&](MotionRecord& r) { r.flags = static_cast<std::uint8_t>(flag); });
    for (std::size_t i = 0; i < 4; ++i) expect_unknown(good_, [&](MotionRecord& r) { r.reserved[i] = 1; });
    for (const unsigned axes : {16U, 128U})
        expect_unknown(good_, [&](MotionRecord& r) { r.axes = static_cast<std::uint8_t>(axes); });
    expect_unknown(good_, [](MotionRecord& r) { r.code = 1; });
    expect_unknown(of_kind(MotionKind::spindle, 2), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::stop, 0), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::stop, 4), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::dwell, 1), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::end, 1), [](MotionRecord&) {});
    expect_unknown(of_kind(MotionKind::end), [](MotionRecord& r) { r.axes = 1; });
    expect_unknown(of_kind(MotionKind::dwell), [](MotionRecord& r) { r.flags = kIsRapid; });
    MotionRecord without_line = good_;
    without_line.line = 0;
    EXPECT_EQ(judge(without_line), MessageId::program_record_unknown);
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

MotionRecord arc_of_head(Axis head, std::array<double, 2> centre_mm, std::array<double, 2> end_mm) {
    MotionRecord record = way_to(static_cast<std::uint8_t>(bit(head) | bit(Axis::y)), {});
    record.kind = MotionKind::arc;
    record.code = static_cast<std::uint8_t>(ArcSense::counterclockwise);
    record.centre_mm = centre_mm;
    record.target[index_of(head)] = end_mm[0];
    record.target[index_of(Axis::y)] = end_mm[1];
    return record;
}

class RecordRulesOfSteps : public RecordRulesTest {
protected:
    RecordRulesOfSteps() {
        const double scale = profile_.y.pulses_per_mm;
        profile_.r1.pulses_per_mm = profile_.r2.pulses_per_mm = scale;
        at_ = {pulses_from_mm(40.0, scale), pulses_from_mm(45.0, scale), 0, pulses_from_mm(50.0, scale)};
    }
};

TEST_F(RecordRulesOfSteps, AnArcOfAHeadAndYBecomesItsPulses) {
    const double scale = profile_.y.pulses_per_mm;
    MotionRecord arc = arc_of_head(Axis::r1, {35.0, 50.0}, {35.0, 55.0});

    ASSERT_EQ(judge(arc), MessageId::none);
    EXPECT_EQ(step_.shape, cycle::OrderShape::arc);
    EXPECT_EQ(step_.stepped_axes, bit(Axis::r1) | bit(Axis::y));
    EXPECT_EQ(step_.target_pulses,
              (Pulses4{pulses_from_mm(35.0, scale), at_[1], 0, pulses_from_mm(55.0, scale)}));
    EXPECT_EQ(step_.centre_pulses[0], pulses_from_mm(35.0, scale));
    arc.code = static_cast<std::uint8_t>(ArcSense::clockwise);
    ASSERT_EQ(judge(arc), MessageId::none);
    EXPECT_EQ(step_.shape, cycle::OrderShape::clockwise);
    EXPECT_EQ(judge(arc_of_head(Axis::r2, {44.0, 50.0}, {44.0, 51.0})), MessageId::none);
    EXPECT_EQ(judge(arc_of_head(Axis::r2, {44.0, 50.0}, {45.0, 50.0})), MessageId::none) << "a whole turn";
}

TEST_F(RecordRulesOfSteps, WhatIsNoArcIsRefused) {
    const MotionRecord arc = arc_of_head(Axis::r1, {35.0, 50.0}, {35.0, 55.0});
    using R = MotionRecord;
    for (const std::uint8_t axes : std::initializer_list<std::uint8_t>{0x0, 0x1, 0x3, 0x8, 0xB, 0xC, 0xD, 0xF})
        EXPECT_EQ(judge(arc, [&](R& r) { r.axes = axes; }), MessageId::program_record_unknown) << int{axes};
    for (const std::uint8_t code : std::initializer_list<std::uint8_t>{0, 3, 255})
        EXPECT_EQ(judge(arc, [&](R& r) { r.code = code; }), MessageId::program_record_unknown);
    for (const std::uint8_t flag : {kIsRapid, kIsStepped})
        EXPECT_EQ(judge(arc, [&](R& r) { r.flags = flag; }), MessageId::program_record_unknown);
    EXPECT_EQ(judge(arc, [](R& r) { r.tolerance_mm = 0.01; }), MessageId::program_record_unknown);
    for (const double wrong : {kNan, kInfinity})
        EXPECT_EQ(judge(arc, [&](R& r) { r.centre_mm[1] = wrong; }), MessageId::program_number_not_finite);
    EXPECT_EQ(judge(arc, [](R& r) { r.centre_mm[0] = 1e30; }), MessageId::program_cannot_count_so_far);
    const double pulse_mm = 1.0 / profile_.y.pulses_per_mm;
    EXPECT_EQ(judge(arc, [&](R& r) { r.target[kYAt] += pulse_mm; }), MessageId::none);
    EXPECT_EQ(judge(arc, [&](R& r) { r.target[kYAt] += 2.0 * pulse_mm; }), MessageId::program_arc_unsound);
    EXPECT_EQ(judge(arc_of_head(Axis::r1, {40.0, 50.0}, {40.0, 50.0})), MessageId::program_arc_unsound);
    EXPECT_EQ(judge(arc_of_head(Axis::r1, {40.0 - pulse_mm, 50.0}, {40.0, 50.0})),
              MessageId::program_arc_unsound);
    profile_.y.pulses_per_mm *= 2.0;
    EXPECT_EQ(judge(arc_of_head(Axis::r1, {40.0, 25.0}, {40.0, 25.0})), MessageId::program_arc_unsound);
}

TEST_F(RecordRulesOfSteps, AnArcIsWithinTravelAllAlong) {
    // Out at the top: y's travel is left there, though both ends are within.
    const AxisMotion y = axis_motion(profile_, Axis::y);
    const double most_mm = mm_from_pulses(y.travel_max_pulses, y.pulses_per_unit);
    at_[kYAt] = pulses_from_mm(most_mm - 2.0, y.pulses_per_unit);
    EXPECT_EQ(judge(arc_of_head(Axis::r1, {37.0, most_mm - 2.0}, {34.0, most_mm - 2.0})),
              MessageId::program_outside_travel);
    EXPECT_EQ(judge(arc_of_head(Axis::r1, {38.0, most_mm - 2.0}, {36.0, most_mm - 2.0})), MessageId::none);
    profile_.core_radius_mm = 36.0;
    EXPECT_EQ(judge(arc_of_head(Axis::r1, {37.5, most_mm - 2.0}, {40.0, most_mm - 2.0})),
              MessageId::program_inside_core_radius);
    profile_.core_radius_mm = 1.0;
    profile_.head_clearance_mm = 81.0;
    EXPECT_EQ(judge(arc_of_head(Axis::r1, {39.0, most_mm - 2.0}, {40.0, most_mm - 2.0})), MessageId::none);
    EXPECT_EQ(judge(arc_of_head(Axis::r1, {37.9, most_mm - 2.0}, {40.0, most_mm - 2.0})),
              MessageId::program_tips_too_close);
}

TEST_F(RecordRulesOfSteps, ASteppedLineHasAHeadOrYOrBoth) {
    MotionRecord line = way_to(bit(Axis::r2) | bit(Axis::y), positions(0.0, 41.0, 0.0, 52.0));
    line.flags = kIsStepped;
    ASSERT_EQ(judge(line), MessageId::none);
    EXPECT_EQ(step_.shape, cycle::OrderShape::stepped);
    for (int axes = 0; axes < 256; ++axes) {
        const bool is_good = axes == 1 || axes == 2 || axes == 8 || axes == 9 || axes == 10;
        line.axes = static_cast<std::uint8_t>(axes);
        line.target = positions(40.0, 41.0, 0.0, 52.0);
        EXPECT_EQ(judge(line), is_good ? MessageId::none : MessageId::program_record_unknown) << axes;
    }
    line.axes = bit(Axis::y);
    EXPECT_EQ(judge(line, [](MotionRecord& r) { r.tolerance_mm = 0.01; }),
              MessageId::program_record_unknown);
    EXPECT_EQ(judge(line, [](MotionRecord& r) { r.flags |= kIsRapid; }), MessageId::program_record_unknown);
    EXPECT_EQ(judge(line, [](MotionRecord& r) { r.centre_mm[0] = 1.0; }), MessageId::program_record_unknown);
}

TEST(RecordRulesSweep, NoPulseOfAGoodArcBreaksALimit) {
    std::mt19937 random{20261128};
    const auto between = [&](double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(random);
    };
    int good = 0;
    int refused = 0;
    for (int round = 0; round < 6'000; ++round) {
        Profile profile;
        profile.r1.pulses_per_mm = profile.r2.pulses_per_mm = profile.y.pulses_per_mm = 20.0;
        profile.head_clearance_mm = between(52.0, 80.0);
        const cycle::SoftLimits limits = plan::cycle_config_from_profile(profile).soft_limits;
        const RecordRules rules{profile};
        const std::size_t head = random() % 2;
        Pulses4 at{1000, 1000, 0, 1000};
        at[head] = pulses_from_mm(between(2.0, 60.0), 20.0);
        at[kYAt] = pulses_from_mm(between(0.0, 150.0), 20.0);
        if (static_cast<double>(at[0] + at[1]) / 20.0 < limits.least_sum_mm) continue;
        const double radius_mm = between(0.05, 30.0);
        const double begin_rad = between(-kPi, kPi);
        const double end_rad = random() % 4 == 0 ? begin_rad : between(-kPi, kPi);
        const std::array<double, 2> centre{
            static_cast<double>(at[head]) / 20.0 - radius_mm * std::cos(begin_rad),
            static_cast<double>(at[kYAt]) / 20.0 - radius_mm * std::sin(begin_rad)};
        MotionRecord record = arc_of_head(static_cast<Axis>(head), centre,
                                          {centre[0] + radius_mm * std::cos(end_rad),
                                           centre[1] + radius_mm * std::sin(end_rad)});
        record.code = static_cast<std::uint8_t>(1 + random() % 2);
        ProgramStep step;
        if (!rules.judge(record, at, step).is_none()) {
            ++refused;
            continue;
        }
        ++good;
        cycle::MotionOrder order{};
        order.axes = step.stepped_axes;
        order.shape = step.shape;
        order.centre_pulses = step.centre_pulses;
        const cycle::ArcInPlane arc = cycle::arc_of(order, at, step.target_pulses);
        auto way = cycle::PointByPoint::arc(arc.begin, arc.end, arc.counter_clockwise);
        for (int steps = 0; !way.is_finished(); ++steps) {
            ASSERT_LT(steps, 8 * arc.radius_pulses + 8) << round;
            const auto moved = way.next();
            at[head] += moved.x;
            at[kYAt] += moved.y;
            for (const std::size_t k : {head, kYAt}) {
                ASSERT_GE(at[k], limits.least_pulses[k]) << round;
                ASSERT_LE(at[k], limits.most_pulses[k]) << round;
            }
            ASSERT_GE(at[head], limits.core_pulses[head]) << round;
            ASSERT_GE(static_cast<double>(at[0] + at[1]) / 20.0, limits.least_sum_mm - 1e-9) << round;
        }
        ASSERT_EQ(at, step.target_pulses) << round;
    }
    EXPECT_GT(good, 1'000);
    EXPECT_GT(refused, 1'000);
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
