// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/layers_in_doubt.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace psicarve::session {
namespace {

constexpr std::uint64_t kStartTick = 1000;
constexpr report::TableSize kTable{6400, 30.0};

CoreStatus started() {
    CoreStatus status{};
    status.job_start_tick = kStartTick;
    return status;
}

void add_alarm(CoreStatus& status, std::uint32_t first_layer, std::uint16_t layer_count,
               std::int64_t off_pulses = 40, std::uint64_t tick = kStartTick + 1) {
    status.alarms[status.alarm_count++ % kAlarmHistory] = {
        tick, AlarmCause::steps_lost, 2, layer_count, first_layer, 19'200, 19'200 + off_pulses};
}

std::string told(const LayersInDoubt& doubt, const report::TableSize& table = kTable) {
    return in_english(doubt_text(doubt, table));
}

TEST(LayersInDoubt, AreThoseOfTheAlarm) {
    LayersInDoubt sut;
    CoreStatus status = started();
    EXPECT_FALSE(sut.take(status));
    EXPECT_EQ(told(sut), "");
    add_alarm(status, 3, 4);
    EXPECT_TRUE(sut.take(status));
    EXPECT_EQ(told(sut), "Layers 4 to 7 can be wrong (≤ 1.178 mm)");
    EXPECT_FALSE(sut.take(status)) << "they were told";
    EXPECT_EQ(told(sut, {}), "Layers 4 to 7 can be wrong");
    sut.forget();
    EXPECT_EQ(told(sut), "");
    EXPECT_FALSE(sut.take(status));
}

TEST(LayersInDoubt, AreOfTheJobOnTheTableAlone) {
    LayersInDoubt sut;
    CoreStatus status = started();
    add_alarm(status, 3, 4, 40, kStartTick - 1);
    add_alarm(status, 3, 0);
    status.alarms[2] = {kStartTick + 1, AlarmCause::limit, 0, 4, 3, 0, 0};
    status.alarm_count = 3;
    EXPECT_FALSE(sut.take(status));
    EXPECT_EQ(told(sut), "");
}

TEST(LayersInDoubt, AreNotTakenTwiceNorFromAnotherCore) {
    LayersInDoubt sut;
    CoreStatus status = started();
    add_alarm(status, 3, 1);
    add_alarm(status, 9, 1, -50);
    EXPECT_TRUE(sut.take(status));
    EXPECT_EQ(told(sut), "2 layers can be wrong, from layer 4 on (≤ 1.473 mm)");
    CoreStatus other = started();
    add_alarm(other, 5, 1);
    EXPECT_TRUE(sut.take(other)) << "its first alarm, though less than two";
    EXPECT_EQ(told(sut), "3 layers can be wrong, from layer 4 on (≤ 1.473 mm)");
}

TEST(LayersInDoubt, ThatMeetBecomeOne) {
    LayersInDoubt sut;
    CoreStatus status = started();
    add_alarm(status, 10, 5);
    add_alarm(status, 2, 3);
    add_alarm(status, 30, 1);
    EXPECT_TRUE(sut.take(status));
    ASSERT_EQ(sut.layers().size(), 3U);
    EXPECT_EQ(sut.layers()[0].first, 2U);
    EXPECT_EQ(sut.layers()[2].first, 30U);
    add_alarm(status, 5, 5);
    EXPECT_TRUE(sut.take(status));
    ASSERT_EQ(sut.layers().size(), 2U);
    EXPECT_EQ(sut.layers()[0].first, 2U);
    EXPECT_EQ(sut.layers()[0].count, 13U);
    add_alarm(status, 3, 2);
    EXPECT_TRUE(sut.take(status));
    EXPECT_EQ(sut.layers()[0].count, 13U) << "it was among them";
}

TEST(LayersInDoubt, AreFreedOfItLayerByLayerAsTheyAreCarvedAgain) {
    LayersInDoubt sut;
    CoreStatus status = started();
    add_alarm(status, 3, 4);
    add_alarm(status, 20, 2, 80);
    EXPECT_TRUE(sut.take(status));
    EXPECT_FALSE(sut.carved_again(0, 3)) << "up to the first of them";
    EXPECT_FALSE(sut.carved_again(7, 20)) << "between them";
    EXPECT_FALSE(sut.carved_again(5, 5));
    EXPECT_FALSE(sut.carved_again(22, 4)) << "the job was started anew";
    EXPECT_EQ(told(sut, {}), "6 layers can be wrong, from layer 4 on");
    EXPECT_TRUE(sut.carved_again(4, 5));
    ASSERT_EQ(sut.layers().size(), 3U);
    EXPECT_EQ(told(sut, {}), "5 layers can be wrong, from layer 4 on");
    EXPECT_TRUE(sut.carved_again(5, 21));
    EXPECT_EQ(told(sut, {}), "2 layers can be wrong, from layer 4 on");
    EXPECT_EQ(sut.layers()[1].first, 21U);
    EXPECT_TRUE(sut.carved_again(21, 30));
    EXPECT_EQ(told(sut), "Layer 4 can be wrong (≤ 2.356 mm)");
    EXPECT_TRUE(sut.carved_again(0, 30));
    EXPECT_EQ(told(sut), "");
    status.job_start_tick = 5000;
    add_alarm(status, 3, 1, 40, 5001);
    EXPECT_TRUE(sut.take(status));
    EXPECT_EQ(told(sut), "Layer 4 can be wrong (≤ 1.178 mm)") << "the 80 pulses are of no layer any more";
}

TEST(LayersInDoubt, TakeWhateverStandsInTheSegment) {
    LayersInDoubt sut;
    CoreStatus status = started();
    add_alarm(status, std::numeric_limits<std::uint32_t>::max(), std::numeric_limits<std::uint16_t>::max());
    add_alarm(status, std::numeric_limits<std::uint32_t>::max() - 5, 3);
    status.alarms[0].expected = std::numeric_limits<std::int64_t>::min();
    status.alarms[0].seen = std::numeric_limits<std::int64_t>::max();
    EXPECT_TRUE(sut.take(status));
    EXPECT_FALSE(told(sut).empty());
    sut.carved_again(0, 100);
    sut.forget();
    EXPECT_EQ(told(sut), "");
}

}  // namespace
}  // namespace psicarve::session
