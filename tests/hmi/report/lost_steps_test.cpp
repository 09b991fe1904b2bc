// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/lost_steps.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hmi/report/status_json.hpp"

namespace psicarve::report {
namespace {

constexpr TableSize kTable{6400, 0.0};

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

std::string told(const AlarmRecord& alarm, const TableSize& table = kTable) {
    const auto lost = lost_steps_of(alarm, table);
    return lost ? lost_steps_text(*lost) : "no lost steps";
}

TEST(LostSteps, AreToldInDegreesWithTheirSignAndByLayer) {
    AlarmRecord alarm = behind();
    EXPECT_EQ(told(alarm), "the table stands -2.250 degrees (-40 pulses) off; layers 3 to 6 can be wrong");
    EXPECT_EQ(told(alarm, {}), "the table stands -40 pulses off; layers 3 to 6 can be wrong");
    EXPECT_EQ(
        told(alarm, {kTable.pulses_per_rev, 30.0}),
        "the table stands -2.250 degrees (-40 pulses, up to 1.178 mm at the blank's surface) off; layers "
        "3 to 6 can be wrong");
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
    const auto lost = alarm_json(alarm, kTable);
    EXPECT_EQ(lost["off_pulses"], -40);
    EXPECT_EQ(lost["off_deg"], -2.25);
    EXPECT_TRUE(lost["most_off_mm"].is_null()) << "how far the blank reaches is not known";
    EXPECT_NEAR(alarm_json(alarm, {kTable.pulses_per_rev, 30.0})["most_off_mm"], -1.178, 0.001);
    EXPECT_EQ(lost["first_layer"], 3);
    EXPECT_EQ(lost["last_layer"], 6);
    EXPECT_TRUE(alarm_json(alarm)["off_deg"].is_null());
    alarm.layer_count = 0;
    EXPECT_TRUE(alarm_json(alarm)["first_layer"].is_null());
    EXPECT_TRUE(alarm_json(alarm)["last_layer"].is_null());
    alarm.cause = AlarmCause::limit;
    EXPECT_TRUE(alarm_json(alarm, kTable)["off_pulses"].is_null());
}

TEST(LostSteps, StandInTheStatus) {
    CoreStatus status{};
    status.alarms[0] = behind();
    status.alarm_count = 1;
    EXPECT_EQ(status_json(status, kTable)["alarms"][0]["off_deg"], -2.25);
    EXPECT_EQ(status_json(status)["alarms"][0]["off_pulses"], -40);
}

}  // namespace
}  // namespace psicarve::report
