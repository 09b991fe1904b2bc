// SPDX-License-Identifier: GPL-3.0-or-later
// Missed ticks on their whole way: tick, flight recorder, script, and the tick again.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "rtcore/replay/replay_script.hpp"
#include "rtcore/supervisor/core_parts.hpp"
#include "rtcore/supervisor/flight_log.hpp"
#include "rtcore/supervisor/replay.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::supervisor {
namespace {

using cycle::MachineRig;

/// What the core's supervisor would have in its recorder now.
std::vector<FlightRecord> recorded(const MachineRig& rig) {
    const auto ring = std::make_unique<FlightRecorder>();
    FlightLog log;
    for (const cycle::Report& report : rig.reports) {
        if (report.record.kind != RecordKind::none) log.append(*ring, report.record);
    }
    std::vector<FlightRecord> records;
    RingReader reader{*ring};
    while (const auto record = reader.next()) records.push_back(*record);
    return records;
}

std::int64_t recorded_missed(const MachineRig& rig) {
    std::int64_t missed = 0;
    for (const FlightRecord& record : recorded(rig)) {
        if (record.kind == RecordKind::gap) missed += record.value;
    }
    return missed;
}

cycle::Sample replayed(const std::vector<FlightRecord>& records, const JobTable& job) {
    auto script = script_from_records(records);
    EXPECT_TRUE(script.has_value());
    // The simulated machine makes them anew.
    std::erase_if(script->steps, [](const ReplayStep& s) { return s.kind == ReplayStep::Kind::inputs; });
    MachineRig rig(cycle::quick_profile());
    EXPECT_TRUE(rig.home());
    rig.load(job);
    RecordDirector director{*script, script->end_tick};
    director.begin(rig.cycle->next_tick());
    CoreParts parts;
    while (!director.is_over(rig.cycle->next_tick())) {
        std::swap(parts.io, rig.io);
        std::swap(parts.cycle, rig.cycle);
        director.before_tick(parts.cycle->next_tick(), parts);
        std::swap(parts.io, rig.io);
        std::swap(parts.cycle, rig.cycle);
        rig.tick();
    }
    return rig.cycle->sample();
}

void carve(MachineRig& rig, const JobTable& job) {
    ASSERT_TRUE(rig.prepare(job));
    ASSERT_EQ(rig.ask(cycle::RequestKind::start_interpolation), cycle::Refusal::none);
    rig.run(3000);
}

void miss_and_run(MachineRig& rig, std::uint64_t missed) {
    rig.cycle->advance_missed(missed);
    rig.run(30);
}

TEST(GapReplay, ALongGapAfterManyShortOnesIsAnAlarmAgain) {
    const JobTable job = cycle::random_job(1, 60, 5);
    MachineRig rig(cycle::quick_profile());
    ASSERT_NO_FATAL_FAILURE(carve(rig, job));
    for (int n = 0; n < 20; ++n) miss_and_run(rig, 2);
    ASSERT_EQ(rig.cycle->state(), MachineState::carving);
    miss_and_run(rig, 60);
    const cycle::Sample original = rig.cycle->sample();
    ASSERT_EQ(original.alarm_cause, AlarmCause::tick_gap);
    const cycle::Sample again = replayed(recorded(rig), job);
    EXPECT_EQ(again.alarm_cause, AlarmCause::tick_gap);
    EXPECT_EQ(again.points_done, original.points_done);
    EXPECT_EQ(again.position_pulses, original.position_pulses);
    EXPECT_EQ(again.missed_ticks, original.missed_ticks);
}

TEST(GapReplay, ShortGapsAloneAreNoneAndOneRecord) {
    const JobTable job = cycle::random_job(1, 60, 5);
    MachineRig rig(cycle::quick_profile());
    ASSERT_NO_FATAL_FAILURE(carve(rig, job));
    for (std::uint64_t n = 0; n < 200; ++n) miss_and_run(rig, 1 + n % 7);
    ASSERT_EQ(rig.cycle->state(), MachineState::carving);
    rig.ask(cycle::RequestKind::hold);
    const auto records = recorded(rig);
    EXPECT_EQ(std::ranges::count(records, RecordKind::gap, &FlightRecord::kind), 1);
    const cycle::Sample again = replayed(records, job);
    EXPECT_EQ(again.alarm_cause, AlarmCause::none);
    EXPECT_EQ(again.missed_ticks, rig.cycle->sample().missed_ticks);
    EXPECT_EQ(again.points_done, rig.cycle->sample().points_done);
}

// One before the first pulse, where any would have been harmless.
TEST(GapReplay, ALongGapAfterOneAtRestIsAnAlarmAgain) {
    const JobTable job = cycle::random_job(1, 60, 5);
    MachineRig rig(cycle::quick_profile());
    ASSERT_TRUE(rig.prepare(job));
    rig.run(3000);
    ASSERT_EQ(rig.ask(cycle::RequestKind::start_interpolation), cycle::Refusal::none);
    rig.cycle->advance_missed(2);
    rig.run(3000);
    miss_and_run(rig, 60);
    ASSERT_EQ(rig.cycle->sample().alarm_cause, AlarmCause::tick_gap);
    const cycle::Sample again = replayed(recorded(rig), job);
    EXPECT_EQ(again.alarm_cause, AlarmCause::tick_gap);
    EXPECT_EQ(again.position_pulses, rig.cycle->sample().position_pulses);
}

// At whichever moment a snapshot is taken, or the core ends or is killed.
TEST(GapReplay, TheRecorderHasWhatTheStatusSays) {
    MachineRig rig(cycle::quick_profile());
    ASSERT_NO_FATAL_FAILURE(carve(rig, cycle::random_job(1, 60, 5)));
    for (int n = 0; n < 50; ++n) {
        miss_and_run(rig, 3);
        ASSERT_EQ(recorded_missed(rig), static_cast<std::int64_t>(rig.cycle->sample().missed_ticks)) << n;
    }
}

// A supervisor that stood still for long: what it hears of afterwards is not gaps alone.
TEST(GapReplay, NoFloodOfGapsKeepsAnAlarmFromBeingTold) {
    MachineRig rig(cycle::quick_profile());
    ASSERT_TRUE(rig.home());
    for (int n = 0; n < 5000; ++n) rig.cycle->advance_missed(3);
    rig.emergency_stop();
    rig.tick();
    EXPECT_EQ(rig.records_of(RecordKind::alarm).size(), 1U);
}

}  // namespace
}  // namespace psicarve::supervisor
