// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/status_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hmi/report/lost_steps.hpp"
#include "shared/base/units.hpp"
#include "shared/computer/realtime_step.hpp"

namespace psicarve::report {
namespace {

template <typename T>
nlohmann::ordered_json by_axis(const T (&values)[kAxisCount]) {
    nlohmann::ordered_json object;
    for (const Axis axis : kAllAxes) object[std::string{name_of(axis)}] = values[index_of(axis)];
    return object;
}

nlohmann::ordered_json axis_or_null(std::uint8_t axis) {
    if (axis >= kAxisCount) return nullptr;
    return std::string{name_of(static_cast<Axis>(axis))};
}

nlohmann::ordered_json seconds_or_null(double seconds) {
    return seconds < 0.0 ? nlohmann::ordered_json() : nlohmann::ordered_json(seconds);
}

nlohmann::ordered_json names_json(SignalWord levels, SignalWord mask) {
    auto names = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        if ((levels & mask & bit_of(signal)) != 0) names.push_back(std::string{name_of(signal)});
    }
    return names;
}

nlohmann::ordered_json homed_json(std::uint8_t mask) {
    nlohmann::ordered_json object;
    for (const Axis axis : kAllAxes) object[std::string{name_of(axis)}] = (mask >> index_of(axis) & 1U) != 0;
    return object;
}

nlohmann::ordered_json lateness_json(const CoreStatus& status) {
    auto bins = nlohmann::ordered_json::array();
    for (const std::uint64_t count : status.lateness_histogram) bins.push_back(count);
    return bins;
}

nlohmann::ordered_json move_end_json(MoveEnd end) {
    switch (end) {
        case MoveEnd::none:
            break;
        case MoveEnd::reached:
            return "reached";
        case MoveEnd::released:
            return "released";
        case MoveEnd::lease_gone:
            return "lease gone";
    }
    return nullptr;
}

nlohmann::ordered_json steps_json(std::uint32_t steps) {
    auto names = nlohmann::ordered_json::array();
    for (const RealtimeStep step : kAllRealtimeSteps) {
        if ((steps & bit_of(step)) != 0) names.push_back(std::string{name_of(step)});
    }
    return names;
}

}  // namespace

std::string signals_text(SignalWord levels, SignalWord mask) {
    std::string names;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        if ((levels & mask & bit_of(signal)) == 0) continue;
        names += (names.empty() ? "" : " ") + std::string{name_of(signal)};
    }
    return names.empty() ? "none" : names;
}

std::vector<AlarmRecord> alarms_of(const CoreStatus& status, std::uint64_t first) {
    const std::uint64_t oldest = status.alarm_count > kAlarmHistory ? status.alarm_count - kAlarmHistory : 0;
    std::vector<AlarmRecord> alarms;
    for (std::uint64_t i = std::max(oldest, first); i < status.alarm_count; ++i) {
        alarms.push_back(status.alarms[i % kAlarmHistory]);
    }
    return alarms;
}

nlohmann::ordered_json alarm_json(const AlarmRecord& alarm, const TableSize& table) {
    const nlohmann::ordered_json none;
    const auto lost = lost_steps_of(alarm, table);
    const bool has_layers = lost && lost->layers;
    return {{"cause", std::string{name_of(alarm.cause)}},
            {"axis", axis_or_null(alarm.axis)},
            {"tick", alarm.tick},
            {"expected", alarm.expected},
            {"seen", alarm.seen},
            {"off_pulses", lost ? nlohmann::ordered_json(lost->off_pulses) : none},
            {"off_deg", lost && lost->off_deg ? nlohmann::ordered_json(*lost->off_deg) : none},
            {"most_off_mm", lost && lost->most_off_mm ? nlohmann::ordered_json(*lost->most_off_mm) : none},
            {"first_layer", has_layers ? nlohmann::ordered_json(lost->layers->first) : none},
            {"last_layer", has_layers ? nlohmann::ordered_json(lost->layers->last) : none}};
}

TableAngle table_angle(std::int64_t pulses, const Profile& profile) {
    const std::int64_t revolution = profile.psi.pulses_per_rev;
    const std::int64_t within = (pulses % revolution + revolution) % revolution;
    return {360.0 * static_cast<double>(within) / static_cast<double>(revolution),
            (pulses - within) / revolution};
}

nlohmann::ordered_json position_json(const CoreStatus& status, const Profile& profile) {
    const auto mm = [&](Axis axis) {
        return mm_from_pulses(status.position_pulses[index_of(axis)],
                              axis_motion(profile, axis).pulses_per_unit);
    };
    const TableAngle table = table_angle(status.position_pulses[index_of(Axis::psi)], profile);
    return {{"r1_mm", mm(Axis::r1)},
            {"r2_mm", mm(Axis::r2)},
            {"psi_deg", table.within_deg},
            {"psi_turns", table.turns},
            {"y_mm", mm(Axis::y)}};
}

nlohmann::ordered_json status_json(const CoreStatus& status, const TableSize& table) {
    auto alarms = nlohmann::ordered_json::array();
    for (const AlarmRecord& alarm : alarms_of(status)) alarms.push_back(alarm_json(alarm, table));
    const bool has_alarm = status.alarm_cause != AlarmCause::none;
    const bool is_running = runs_job(status.state);
    return {{"state", std::string{name_of(status.state)}},
            {"alarm_cause", has_alarm ? nlohmann::ordered_json(std::string{name_of(status.alarm_cause)})
                                      : nlohmann::ordered_json()},
            {"alarm_axis", has_alarm ? axis_or_null(status.alarm_axis) : nlohmann::ordered_json()},
            {"position_pulses", by_axis(status.position_pulses)},
            {"homed", homed_json(status.homed_mask)},
            {"move_end", move_end_json(status.move_end)},
            {"emitted_pulses", by_axis(status.emitted_pulses)},
            {"port_silent", status.is_port_silent != 0},
            {"dry_run", status.is_dry != 0},
            {"layer", status.layer},
            {"point", status.point},
            {"points_done", status.points_done},
            {"points_total", status.points_total},
            {"job_generation", status.job_generation},
            {"seconds_left", seconds_or_null(is_running ? status.seconds_left : -1.0)},
            {"seconds_left_is_estimate", is_running && status.is_left_forecast != 0},
            {"planned_seconds", seconds_or_null(is_running ? -1.0 : status.seconds_left)},
            {"reference_seconds", seconds_or_null(status.reference_seconds)},
            {"outputs", names_json(status.signals, kOutputMask)},
            {"inputs", names_json(status.signals, kInputMask)},
            {"tick", status.tick},
            {"period_ns", status.period_ns},
            {"heartbeat", status.heartbeat},
            {"override_percent", status.override_percent},
            {"rapid_override_percent", rapid_override_percent(status)},
            {"waited_ticks", status.waited_ticks},
            {"missed_ticks", status.missed_ticks},
            {"max_lateness_ns", status.max_lateness_ns},
            {"lateness_histogram", lateness_json(status)},
            {"simulator", status.is_simulator != 0},
            {"virtual_clock", status.is_virtual_clock != 0},
            {"realtime_rights", status.has_realtime_rights != 0},
            {"realtime_done", steps_json(status.realtime_done)},
            {"realtime_refused", steps_json(status.realtime_asked & ~status.realtime_done)},
            {"tick_cpu",
             status.tick_cpu < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(status.tick_cpu)},
            {"tick_priority", status.tick_priority},
            {"tick_minor_faults", status.tick_minor_faults},
            {"tick_major_faults", status.tick_major_faults},
            {"tick_sleeps", status.tick_sleeps},
            {"tick_preemptions", status.tick_preemptions},
            {"alarm_count", status.alarm_count},
            {"alarms", alarms},
            {"trace_lost", status.trace_lost},
            {"sim_true_position_pulses", by_axis(status.sim_true_position_pulses)},
            {"sim_ignored_pulses", by_axis(status.sim_ignored_pulses)},
            {"sim_timing_lost", by_axis(status.sim_timing_lost)},
            {"sim_stalls", by_axis(status.sim_stalls)}};
}

}  // namespace psicarve::report
