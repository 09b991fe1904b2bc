// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/status_mirror.hpp"

#include <algorithm>

#include "rtcore/sim/machine.hpp"

namespace psicarve::supervisor {

SimFacts sim_facts(const sim::Machine& machine) {
    const sim::SimReport report = machine.report();
    SimFacts facts;
    for (const Axis axis : kAllAxes) {
        const std::size_t i = index_of(axis);
        facts.true_position_pulses[i] = report.axis(axis).position_pulses;
        facts.ignored_pulses[i] = report.axis(axis).pulses_ignored;
        facts.timing_lost[i] = report.axis(axis).timing_lost();
        facts.stalls[i] = report.axis(axis).stalls;
    }
    return facts;
}

void StatusMirror::note_alarm(const cycle::Report& report) noexcept {
    const FlightRecord& record = report.record;
    AlarmRecord& alarm = alarms_[alarm_count_ % kAlarmHistory];
    alarm = AlarmRecord{};
    alarm.tick = record.tick;
    alarm.cause = static_cast<AlarmCause>(record.code);
    alarm.axis = static_cast<std::uint8_t>(record.axis);
    alarm.layer_count = report.layer_count;
    alarm.first_layer = report.first_layer;
    alarm.expected = report.expected_pulses;
    alarm.seen = record.value;
    ++alarm_count_;
}

CoreStatus StatusMirror::compose(const cycle::Sample& sample, const PlannedTimes& times) noexcept {
    CoreStatus status{};
    status.tick = sample.tick;
    status.heartbeat = ++heartbeat_;
    status.period_ns = facts_.period_ns;
    status.state = sample.state;
    status.alarm_cause = sample.alarm_cause;
    status.alarm_axis = sample.alarm_axis;
    status.homed_mask = sample.homed_mask;
    status.is_simulator = facts_.is_simulator ? 1 : 0;
    status.is_virtual_clock = facts_.is_virtual_clock ? 1 : 0;
    status.has_realtime_rights = realtime_.has_rights() ? 1 : 0;
    status.missing_sensors_mask = facts_.missing_sensors_mask;
    std::ranges::copy(sample.position_pulses, status.position_pulses);
    std::ranges::copy(sample.emitted_pulses, status.emitted_pulses);
    status.layer = sample.layer;
    status.point = sample.point;
    status.points_done = sample.points_done;
    status.points_total = sample.points_total;
    status.job_generation = sample.job_generation;
    status.signals = sample.signals;
    status.move_end = sample.move_end;
    status.seconds_left = times.left_s;
    status.reference_seconds = times.reference_s;
    status.job_start_tick = sample.job_start_tick;
    status.carve_first_tick = sample.carve_first_tick;
    status.carve_last_tick = sample.carve_last_tick;
    status.job_end_tick = sample.job_end_tick;
    status.missed_ticks = sample.missed_ticks;
    status.waited_ticks = sample.waited_ticks;
    status.override_percent = static_cast<std::uint16_t>(sample.override_percent);
    status.rapid_override_percent = static_cast<std::uint16_t>(sample.rapid_override_percent);
    status.is_dry = sample.is_dry;
    status.is_left_forecast = times.is_left_forecast ? 1 : 0;
    status.is_port_silent = sample.is_port_silent;
    status.trace_lost = sample.trace_lost;
    status.realtime_asked = realtime_.asked;
    status.realtime_done = realtime_.done;
    status.tick_cpu = realtime_.tick_cpu;
    status.tick_priority = realtime_.tick_priority;
    status.tick_minor_faults = realtime_.tick_counts.minor_faults;
    status.tick_major_faults = realtime_.tick_counts.major_faults;
    status.tick_sleeps = realtime_.tick_counts.sleeps;
    status.tick_preemptions = realtime_.tick_counts.preemptions;
    status.max_lateness_ns = lateness_.max_ns;
    std::ranges::copy(lateness_.histogram, status.lateness_histogram);
    status.alarm_count = alarm_count_;
    std::ranges::copy(alarms_, status.alarms);
    std::ranges::copy(sim_.true_position_pulses, status.sim_true_position_pulses);
    std::ranges::copy(sim_.ignored_pulses, status.sim_ignored_pulses);
    std::ranges::copy(sim_.timing_lost, status.sim_timing_lost);
    std::ranges::copy(sim_.stalls, status.sim_stalls);
    status.seconds_left *= stretch_of(sample.override_percent);
    return status;
}

double stretch_of(std::uint64_t override_percent) noexcept {
    if (override_percent == 0 || override_percent >= 100) return 1.0;
    return 100.0 / static_cast<double>(override_percent);
}

}  // namespace psicarve::supervisor
