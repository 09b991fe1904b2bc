// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/lost_steps.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hmi/report/status_json.hpp"

namespace psicarve::report {
namespace {

constexpr std::int64_t kPulsesPerRev = 6400;

/// The count went on by 40 pulses that the table did not follow.
AlarmRecord behind() {
    AlarmRecord alarm{};
    alarm.cause = AlarmCause::steps_lost;
    alarm.axis = 2;
    alarm.first_layer = 3;
    alarm.layer_count = 4;
    alarm.expected = 19'200;
    alarm.seen = 19'240;
    return alarm;
}

std::string told(const AlarmRecord& alarm, std::int64_t pulses_per_rev = kPulsesPerRev) {
    const auto lost = lost_steps_of(alarm, pulses_per_rev);
    return lost ? lost_steps_text(*lost) : "no lost steps";
}

TEST(LostSteps, AreToldInDegreesWithTheirSignAndByLayer) {
    AlarmRecord alarm = behind();
    EXPECT_EQ(told(alarm), "the table stands -2.250 degrees (-40 pulses) off; layers 3 to 6 can be wrong");
    EXPECT_EQ(told(alarm, 0), "the table stands -40 pulses off; layers 3 to 6 can be wrong");
    alarm.seen = 19'197;
    alarm.layer_count = 1;
    EXPECT_EQ(told(alarm), "the table stands +0.169 degrees (+3 pulses) off; layer 3 can be wrong");
    alarm.layer_count = 0;
    EXPECT_EQ(told(alarm), "the table stands +0.169 degrees (+3 pulses) off");
    alarm.cause = AlarmCause::limit;
    EXPECT_EQ(told(alarm), "no lost steps");
}

TEST(LostSteps, StandInTheJsonOfTheirAlarm) {
    AlarmRecord alarm = behind();
    const auto lost = alarm_json(alarm, kPulsesPerRev);
    EXPECT_EQ(lost["off_pulses"], -40);
    EXPECT_EQ(lost["off_deg"], -2.25);
    EXPECT_EQ(lost["first_layer"], 3);
    EXPECT_EQ(lost["last_layer"], 6);
    EXPECT_TRUE(alarm_json(alarm)["off_deg"].is_null());
    alarm.layer_count = 0;
    EXPECT_TRUE(alarm_json(alarm)["first_layer"].is_null());
    EXPECT_TRUE(alarm_json(alarm)["last_layer"].is_null());
    alarm.cause = AlarmCause::limit;
    EXPECT_TRUE(alarm_json(alarm, kPulsesPerRev)["off_pulses"].is_null());
}

TEST(LostSteps, StandInTheStatus) {
    CoreStatus status{};
    status.alarms[0] = behind();
    status.alarm_count = 1;
    EXPECT_EQ(status_json(status, kPulsesPerRev)["alarms"][0]["off_deg"], -2.25);
    EXPECT_EQ(status_json(status)["alarms"][0]["off_pulses"], -40);
}

}  // namespace
}  // namespace psicarve::report
