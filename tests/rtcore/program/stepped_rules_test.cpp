// SPDX-License-Identifier: GPL-3.0-or-later
// What the core asks of ways and arcs by point-by-point comparison.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <random>

#include "rtcore/cycle/arc_order.hpp"
#include "rtcore/cycle/soft_limits.hpp"
#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "rtcore/program/record_rules.hpp"
#include "shared/base/units.hpp"
#include "tests/rtcore/program/program_in_memory.hpp"

namespace psicarve::program {
namespace {

using plan::ProgramStep;
using plan::Pulses4;
using test::positions;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kTooFar = std::numeric_limits<double>::infinity();
constexpr std::size_t kArcYAt = index_of(Axis::y);

constexpr std::uint8_t axis_bit(Axis axis) {
    return static_cast<std::uint8_t>(1U << index_of(axis));
}

MotionRecord stepped_way_to(std::uint8_t axes, std::array<double, kAxisCount> target) {
    MotionRecord record{};
    record.line = 12;
    record.kind = MotionKind::way;
    record.axes = axes;
    record.target = target;
    return record;
}

MotionRecord arc_of_head(Axis head, std::array<double, 2> centre_mm, std::array<double, 2> end_mm) {
    MotionRecord record = stepped_way_to(static_cast<std::uint8_t>(axis_bit(head) | axis_bit(Axis::y)), {});
    record.kind = MotionKind::arc;
    record.code = static_cast<std::uint8_t>(ArcSense::counterclockwise);
    record.centre_mm = centre_mm;
    record.target[index_of(head)] = end_mm[0];
    record.target[index_of(Axis::y)] = end_mm[1];
    return record;
}

class RecordRulesOfSteps : public testing::Test {
protected:
    RecordRulesOfSteps() {
        const double scale = profile_.y.pulses_per_mm;
        profile_.r1.pulses_per_mm = profile_.r2.pulses_per_mm = scale;
        at_ = {pulses_from_mm(40.0, scale), pulses_from_mm(45.0, scale), 0, pulses_from_mm(50.0, scale)};
    }
    MessageId judge(const MotionRecord& record) {
        const Message said = RecordRules{profile_}.judge(record, at_, step_);
        if (!said.is_none()) {
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
    Pulses4 at_;
    ProgramStep step_;
};

TEST_F(RecordRulesOfSteps, AnArcOfAHeadAndYBecomesItsPulses) {
    const double scale = profile_.y.pulses_per_mm;
    MotionRecord arc = arc_of_head(Axis::r1, {35.0, 50.0}, {35.0, 55.0});

    ASSERT_EQ(judge(arc), MessageId::none);
    EXPECT_EQ(step_.shape, cycle::OrderShape::arc);
    EXPECT_EQ(step_.stepped_axes, axis_bit(Axis::r1) | axis_bit(Axis::y));
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
    for (const std::uint8_t axes :
         std::initializer_list<std::uint8_t>{0x0, 0x1, 0x3, 0x8, 0xB, 0xC, 0xD, 0xF})
        EXPECT_EQ(judge(arc, [&](R& r) { r.axes = axes; }), MessageId::program_record_unknown) << int{axes};
    for (const std::uint8_t code : std::initializer_list<std::uint8_t>{0, 3, 255})
        EXPECT_EQ(judge(arc, [&](R& r) { r.code = code; }), MessageId::program_record_unknown);
    for (const std::uint8_t flag : {kIsRapid, kIsStepped})
        EXPECT_EQ(judge(arc, [&](R& r) { r.flags = flag; }), MessageId::program_record_unknown);
    EXPECT_EQ(judge(arc, [](R& r) { r.tolerance_mm = 0.01; }), MessageId::program_record_unknown);
    for (const double wrong : {kNoNumber, kTooFar})
        EXPECT_EQ(judge(arc, [&](R& r) { r.centre_mm[1] = wrong; }), MessageId::program_number_not_finite);
    EXPECT_EQ(judge(arc, [](R& r) { r.centre_mm[0] = 1e30; }), MessageId::program_cannot_count_so_far);
    const double pulse_mm = 1.0 / profile_.y.pulses_per_mm;
    EXPECT_EQ(judge(arc, [&](R& r) { r.target[kArcYAt] += pulse_mm; }), MessageId::none);
    EXPECT_EQ(judge(arc, [&](R& r) { r.target[kArcYAt] += 2.0 * pulse_mm; }), MessageId::program_arc_unsound);
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
    at_[kArcYAt] = pulses_from_mm(most_mm - 2.0, y.pulses_per_unit);
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
    MotionRecord line =
        stepped_way_to(axis_bit(Axis::r2) | axis_bit(Axis::y), positions(0.0, 41.0, 0.0, 52.0));
    line.flags = kIsStepped;
    ASSERT_EQ(judge(line), MessageId::none);
    EXPECT_EQ(step_.shape, cycle::OrderShape::stepped);
    for (int axes = 0; axes < 256; ++axes) {
        const bool is_good = axes == 1 || axes == 2 || axes == 8 || axes == 9 || axes == 10;
        line.axes = static_cast<std::uint8_t>(axes);
        line.target = positions(40.0, 41.0, 0.0, 52.0);
        EXPECT_EQ(judge(line), is_good ? MessageId::none : MessageId::program_record_unknown) << axes;
    }
    line.axes = axis_bit(Axis::y);
    EXPECT_EQ(judge(line, [](MotionRecord& r) { r.tolerance_mm = 0.01; }), MessageId::program_record_unknown);
    EXPECT_EQ(judge(line, [](MotionRecord& r) { r.flags |= kIsRapid; }), MessageId::program_record_unknown);
    EXPECT_EQ(judge(line, [](MotionRecord& r) { r.centre_mm[0] = 1.0; }), MessageId::program_record_unknown);
}

TEST(RecordRulesOfStepsSweep, NoPulseOfAGoodArcBreaksALimit) {
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
        at[kArcYAt] = pulses_from_mm(between(0.0, 150.0), 20.0);
        if (static_cast<double>(at[0] + at[1]) / 20.0 < limits.least_sum_mm) continue;
        const double radius_mm = between(0.05, 30.0);
        const double begin_rad = between(-kPi, kPi);
        const double end_rad = random() % 4 == 0 ? begin_rad : between(-kPi, kPi);
        const std::array<double, 2> centre{
            static_cast<double>(at[head]) / 20.0 - radius_mm * std::cos(begin_rad),
            static_cast<double>(at[kArcYAt]) / 20.0 - radius_mm * std::sin(begin_rad)};
        MotionRecord record = arc_of_head(
            static_cast<Axis>(head), centre,
            {centre[0] + radius_mm * std::cos(end_rad), centre[1] + radius_mm * std::sin(end_rad)});
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
            at[kArcYAt] += moved.y;
            for (const std::size_t k : {head, kArcYAt}) {
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

}  // namespace
}  // namespace psicarve::program
