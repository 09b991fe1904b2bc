// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/status_text.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "hmi/cli/progress_bar.hpp"
#include "shared/realtime_step.hpp"
#include "shared/units.hpp"

namespace psicarve::cli {
namespace {

template <typename... Args>
std::string formatted(const char* format, Args... args) {
    char text[256];
    std::snprintf(text, sizeof text, format, args...);
    return text;
}

std::string axes_in(std::uint8_t mask) {
    std::string names;
    for (const Axis axis : kAllAxes) {
        if ((mask >> index_of(axis) & 1U) == 0) continue;
        names += (names.empty() ? "" : " ") + std::string{name_of(axis)};
    }
    return names.empty() ? "none" : names;
}

std::string position_text(const CoreStatus& status, const Profile* profile, Axis axis) {
    const std::int64_t pulses = status.position_pulses[index_of(axis)];
    const std::string name{name_of(axis)};
    if (profile == nullptr) return formatted("%s %lld pulses", name.c_str(), static_cast<long long>(pulses));
    const double value = static_cast<double>(pulses) / axis_motion(*profile, axis).pulses_per_unit;
    return formatted("%s %.3f %s (%lld)", name.c_str(), value, axis == Axis::psi ? "deg" : "mm",
                     static_cast<long long>(pulses));
}

std::string progress_text(const CoreStatus& status) {
    if (status.points_total == 0) return "none accepted";
    std::string text =
        formatted("generation %llu, %llu of %llu points (%.1f %%), layer %u, point %u",
                  static_cast<unsigned long long>(status.job_generation),
                  static_cast<unsigned long long>(status.points_done),
                  static_cast<unsigned long long>(status.points_total),
                  100.0 * static_cast<double>(status.points_done) / static_cast<double>(status.points_total),
                  status.layer, status.point);
    if (status.seconds_left >= 0.0)
        text += ", " + clock_text(status.seconds_left) + (runs_job(status.state) ? " left" : " planned");
    return text;
}

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

/// How the tick's thread is treated, and what to do about what was refused; empty on the virtual clock.
std::string realtime_text(const CoreStatus& status) {
    if (status.realtime_asked == 0) return {};
    std::string text = "real time  ";
    text +=
        status.tick_priority == 0 ? "ordinary scheduling" : formatted("SCHED_FIFO %u", status.tick_priority);
    text += status.tick_cpu < 0 ? ", any processor" : formatted(", processor %d", status.tick_cpu);
    const std::uint64_t faults = status.tick_minor_faults + status.tick_major_faults;
    text += "; page faults " + std::to_string(faults) + ", of them from disk " +
            std::to_string(status.tick_major_faults) + "; preempted " +
            std::to_string(status.tick_preemptions) + " times\n";
    for (const RealtimeStep step : kAllRealtimeSteps) {
        if ((status.realtime_asked & ~status.realtime_done & bit_of(step)) == 0) continue;
        text += "refused    " + std::string{name_of(step)} + "\nremedy     " + std::string{remedy_of(step)} +
                "\n";
    }
    return text;
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

std::string state_text(const CoreStatus& status) {
    if (status.state != MachineState::alarm) return std::string{name_of(status.state)};
    std::string text = "in alarm (" + std::string{name_of(status.alarm_cause)};
    if (status.alarm_axis < kAxisCount)
        text += " of " + std::string{name_of(static_cast<Axis>(status.alarm_axis))};
    return text + ")";
}

std::vector<AlarmRecord> alarms_of(const CoreStatus& status, std::uint64_t first) {
    const std::uint64_t oldest = status.alarm_count > kAlarmHistory ? status.alarm_count - kAlarmHistory : 0;
    std::vector<AlarmRecord> alarms;
    for (std::uint64_t i = std::max(oldest, first); i < status.alarm_count; ++i) {
        alarms.push_back(status.alarms[i % kAlarmHistory]);
    }
    return alarms;
}

std::string status_text(const CoreStatus& status, const Profile* profile) {
    std::string text = "state      " + state_text(status) + "\n";
    if (status.state == MachineState::alarm)
        text += "remedy     " + std::string{remedy_of(status.alarm_cause)} + "\n";
    text += "position   ";
    for (const Axis axis : kAllAxes)
        text += (axis == Axis::r1 ? "" : ", ") + position_text(status, profile, axis);
    text += "\nhomed      " + axes_in(status.homed_mask) + "\n";
    text += "job        " + progress_text(status) + "\n";
    text += formatted("override   %u %% of the planned feed\n", status.override_percent);
    text += "drives on  " + axes_in(static_cast<std::uint8_t>((status.signals & kEnableMask) >> 8U)) +
            ", spindle " + ((status.signals & bit_of(Signal::spindle)) != 0 ? "on" : "off") + "\n";
    text += "tripped    " + signals_text(status.signals, kInputMask) + "\n";
    text += formatted(
        "core       %s, %s clock, tick %.0f us, %llu ticks, %llu missed, at most %.1f us late\n",
        status.is_simulator != 0 ? "simulated machine" : "real port",
        status.is_virtual_clock != 0 ? "virtual" : "real",
        static_cast<double>(status.period_ns) / static_cast<double>(kNsPerUs),
        static_cast<unsigned long long>(status.tick), static_cast<unsigned long long>(status.missed_ticks),
        static_cast<double>(status.max_lateness_ns) / static_cast<double>(kNsPerUs));
    text += realtime_text(status);
    text += formatted("alarms     %llu since the core started\n",
                      static_cast<unsigned long long>(status.alarm_count));
    return text;
}

std::string status_line(const CoreStatus& status) {
    return state_text(status) + "; job " + progress_text(status) + "; tripped " +
           signals_text(status.signals, kInputMask & ~bit_of(Signal::psi_index)) + "\n";
}

nlohmann::ordered_json alarm_json(const AlarmRecord& alarm) {
    return {{"cause", std::string{name_of(alarm.cause)}},
            {"axis", axis_or_null(alarm.axis)},
            {"tick", alarm.tick},
            {"expected", alarm.expected},
            {"seen", alarm.seen}};
}

nlohmann::ordered_json status_json(const CoreStatus& status) {
    auto alarms = nlohmann::ordered_json::array();
    for (const AlarmRecord& alarm : alarms_of(status)) alarms.push_back(alarm_json(alarm));
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
            {"layer", status.layer},
            {"point", status.point},
            {"points_done", status.points_done},
            {"points_total", status.points_total},
            {"job_generation", status.job_generation},
            {"seconds_left", seconds_or_null(is_running ? status.seconds_left : -1.0)},
            {"planned_seconds", seconds_or_null(is_running ? -1.0 : status.seconds_left)},
            {"reference_seconds", seconds_or_null(status.reference_seconds)},
            {"outputs", names_json(status.signals, kOutputMask)},
            {"inputs", names_json(status.signals, kInputMask)},
            {"tick", status.tick},
            {"period_ns", status.period_ns},
            {"heartbeat", status.heartbeat},
            {"override_percent", status.override_percent},
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

}  // namespace psicarve::cli
