// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/status_mirror.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace psicarve::supervisor {
namespace {

TEST(StatusMirror, ShowsTheTimeLeftAsTheOverrideStretchesIt) {
    EXPECT_DOUBLE_EQ(10.0 * stretch_of(40), 25.0);
    EXPECT_DOUBLE_EQ(10.0 * stretch_of(100), 10.0);
    EXPECT_DOUBLE_EQ(10.0 * stretch_of(200), 10.0) << "what the motors leave is not known";
}

TEST(StatusMirror, ShowsWhatAnAlarmSaysOfLostSteps) {
    StatusMirror sut{CoreFacts{}};
    cycle::Report report{};
    report.record.kind = RecordKind::alarm;
    report.record.code = static_cast<std::uint16_t>(AlarmCause::steps_lost);
    report.record.axis = 2;
    report.record.tick = 77;
    report.record.value = 19'240;
    report.expected_pulses = 19'200;
    report.first_layer = 3;
    report.layer_count = 4;
    sut.note_alarm(report);
    const CoreStatus status = sut.compose(cycle::Sample{}, PlannedTimes{});
    ASSERT_EQ(status.alarm_count, 1U);
    const AlarmRecord& alarm = status.alarms[0];
    EXPECT_EQ(alarm.cause, AlarmCause::steps_lost);
    EXPECT_EQ(alarm.tick, 77U);
    EXPECT_EQ(alarm.expected, 19'200);
    EXPECT_EQ(alarm.seen, 19'240);
    EXPECT_EQ(alarm.first_layer, 3U);
    EXPECT_EQ(alarm.layer_count, 4U);
}

}  // namespace
}  // namespace psicarve::supervisor
