// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/sensor_search.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

constexpr std::int64_t kSearchFilter_ticks = 3;

CycleConfig search_config() {
    CycleConfig config;
    config.filter_ticks = kSearchFilter_ticks;
    config.input_mask = kLimitMask | kIndexBit | kEstopBit;
    return config;
}

MotionBlock search_block(Axis axis, Until until, bool is_homing = true) {
    MotionBlock block{};
    block.kind = BlockKind::move;
    block.axis = static_cast<std::uint8_t>(index_of(axis));
    block.until = until;
    block.is_homing = is_homing ? 1 : 0;
    return block;
}

struct SearchRig {
    Inputs inputs{search_config()};
    SensorSearch sut{inputs};
    std::uint64_t now = 0;

    /// One tick with these levels; whether the sensor answers in it.
    bool tick(SignalWord levels) {
        inputs.take(levels, now, {static_cast<std::int64_t>(now), 0, 0, 0});
        ++now;
        return sut.watch();
    }
};

TEST(SensorSearch, AnswersOnceWhenTheFilterBelievesATrippedSensor) {
    SearchRig rig;
    rig.sut.begin(search_block(Axis::r1, Until::sensor_tripped));
    EXPECT_TRUE(rig.sut.is_on());
    EXPECT_FALSE(rig.tick(0));
    EXPECT_FALSE(rig.sut.may_answer());
    for (std::int64_t tick = 0; tick < kSearchFilter_ticks; ++tick) {
        EXPECT_FALSE(rig.tick(bit_of(Signal::r1_limit)));
        EXPECT_TRUE(rig.sut.may_answer());
        EXPECT_FALSE(rig.sut.has_answered());
    }
    EXPECT_TRUE(rig.tick(bit_of(Signal::r1_limit)));
    EXPECT_TRUE(rig.sut.has_answered());
    EXPECT_EQ(rig.sut.edge_position(), 1) << "where the raw level changed, not where it was believed";
    EXPECT_FALSE(rig.tick(bit_of(Signal::r1_limit)));
    EXPECT_TRUE(rig.sut.has_answered());
}

TEST(SensorSearch, HeedsNoOtherAxisSensor) {
    SearchRig rig;
    rig.sut.begin(search_block(Axis::r1, Until::sensor_tripped));
    for (int tick = 0; tick < 10; ++tick) EXPECT_FALSE(rig.tick(bit_of(Signal::r2_limit)));
    EXPECT_FALSE(rig.sut.may_answer());
}

// A sensor that chatters while it is left is not left yet.
TEST(SensorSearch, CallsASensorClearWhenNeitherItsLevelNorItsFilterSaysTripped) {
    SearchRig rig;
    for (int tick = 0; tick < 5; ++tick) rig.tick(bit_of(Signal::y_limit));
    rig.sut.begin(search_block(Axis::y, Until::sensor_clear));
    EXPECT_FALSE(rig.tick(bit_of(Signal::y_limit)));
    for (std::int64_t tick = 0; tick < kSearchFilter_ticks; ++tick) EXPECT_FALSE(rig.tick(0));
    EXPECT_TRUE(rig.tick(0));

    SearchRig chattering;
    for (int tick = 0; tick < 5; ++tick) chattering.tick(0);
    chattering.sut.begin(search_block(Axis::y, Until::sensor_clear));
    EXPECT_FALSE(chattering.tick(bit_of(Signal::y_limit)));
    EXPECT_TRUE(chattering.tick(0));
}

TEST(SensorSearch, WaitsForAnEdgeOfTheIndexNotForItsLevel) {
    SearchRig rig;
    rig.tick(kIndexBit);
    rig.sut.begin(search_block(Axis::psi, Until::index_edge));
    EXPECT_FALSE(rig.tick(kIndexBit)) << "it was tripped before the move began";
    EXPECT_FALSE(rig.tick(0));
    EXPECT_TRUE(rig.tick(kIndexBit));
    EXPECT_FALSE(rig.tick(0));
    EXPECT_FALSE(rig.tick(kIndexBit));
}

TEST(SensorSearch, ForgetsTheAnswerOfTheMoveBefore) {
    SearchRig rig;
    rig.sut.begin(search_block(Axis::psi, Until::index_edge));
    rig.tick(0);
    ASSERT_TRUE(rig.tick(kIndexBit));
    rig.sut.begin(search_block(Axis::psi, Until::none));
    EXPECT_FALSE(rig.sut.is_on());
    EXPECT_FALSE(rig.sut.has_answered());
}

TEST(SensorSearch, ExemptsTheAxisFromItsFirstHomingBlockUntilAnotherMotionOrTheEnd) {
    SearchRig rig;
    EXPECT_EQ(rig.sut.homing_axis(), kNoAxis);
    rig.sut.begin(search_block(Axis::r2, Until::sensor_tripped));
    EXPECT_EQ(rig.sut.homing_axis(), index_of(Axis::r2));
    rig.sut.begin(search_block(Axis::y, Until::sensor_tripped, false));
    EXPECT_EQ(rig.sut.homing_axis(), kNoAxis);
    rig.sut.begin(search_block(Axis::r1, Until::none));
    EXPECT_EQ(rig.sut.homing_axis(), index_of(Axis::r1));
    rig.sut.end_homing();
    EXPECT_EQ(rig.sut.homing_axis(), kNoAxis);
}

}  // namespace
}  // namespace psicarve::cycle
