// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/status_text.hpp"

#include <cstdio>

#include "hmi/cli/progress_bar.hpp"
#include "hmi/report/lost_steps.hpp"
#include "hmi/report/status_json.hpp"
#include "shared/base/units.hpp"
#include "shared/computer/realtime_step.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/profile/pin_map.hpp"

namespace psicarve::cli {
namespace {

using report::signals_text;

template <typename... Args>
std::string formatted_status(const char* format, Args... args) {
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
    if (profile == nullptr)
        return formatted_status("%s %lld pulses", name.c_str(), static_cast<long long>(pulses));
    if (axis == Axis::psi) {
        const report::TableAngle angle = report::table_angle(pulses, *profile);
        const long long turns = static_cast<long long>(angle.turns);
        return formatted_status("psi %.3f deg", angle.within_deg) +
               (turns == 0 ? "" : formatted_status(" and %lld %s", turns, turns == 1 ? "turn" : "turns")) +
               formatted_status(" (%lld)", static_cast<long long>(pulses));
    }
    const double value = static_cast<double>(pulses) / axis_motion(*profile, axis).pulses_per_unit;
    return formatted_status("%s %.3f mm (%lld)", name.c_str(), value, static_cast<long long>(pulses));
}

std::string progress_text(const CoreStatus& status, const std::string& pass) {
    if (status.points_total == 0) return "none accepted";
    std::string text = formatted_status(
        "generation %llu, %llu of %llu points (%.1f %%), layer %u, point %u",
        static_cast<unsigned long long>(status.job_generation),
        static_cast<unsigned long long>(status.points_done),
        static_cast<unsigned long long>(status.points_total),
        100.0 * static_cast<double>(status.points_done) / static_cast<double>(status.points_total),
        status.layer, status.point);
    if (!pass.empty()) text += ", " + pass;
    if (status.is_dry != 0 && runs_job(status.state)) text += ", dry run";
    if (status.seconds_left >= 0.0)
        text += ", " + to_go_text({status.seconds_left, status.is_left_forecast != 0}) +
                (runs_job(status.state) ? " left" : " planned");
    return text;
}

/// How the tick's thread is set up, and the remedies for refused steps; empty on the virtual clock.
std::string realtime_text(const CoreStatus& status) {
    if (status.realtime_asked == 0) return {};
    std::string text = "real time  ";
    text += status.tick_priority == 0 ? "ordinary scheduling"
                                      : formatted_status("SCHED_FIFO %u", status.tick_priority);
    text += status.tick_cpu < 0 ? ", any processor" : formatted_status(", processor %d", status.tick_cpu);
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

/// ", on: mist output_2", none: "".
std::string switched_text(SignalWord levels) {
    if ((levels & kSwitchedMask) == 0) return {};
    return ", on: " + signals_text(levels, kSwitchedMask);
}

std::string outputs_text(const CoreStatus& status, const Profile* profile) {
    const bool is_spindle_on = (status.signals & bit_of(Signal::spindle)) != 0;
    const std::string drives =
        axes_in(static_cast<std::uint8_t>((status.signals & kEnableMask) >> index_of(Signal::r1_enable)));
    if (status.is_port_silent == 0)
        return "drives on  " + drives + ", spindle " + (is_spindle_on ? "on" : "off") +
               switched_text(status.signals) + "\n";
    return "port       does not answer: " + names_of_powered(profile != nullptr ? *profile : Profile{}) +
           " may be ON; switch the machine off by its own switch\ndrives     last on: " + drives +
           "; spindle last " + (is_spindle_on ? "on" : "off") + switched_text(status.signals) +
           "; the core goes on trying\n";
}

/// For a latched alarm about lost steps.
std::string latched_lost_text(const CoreStatus& status, const Profile* profile) {
    const auto alarms = report::alarms_of(status);
    if (alarms.empty() || status.alarm_cause != AlarmCause::steps_lost) return {};
    const auto table = profile != nullptr ? report::TableSize::of(*profile) : report::TableSize{};
    const auto lost = report::lost_steps_of(alarms.back(), table);
    return lost ? "lost       " + report::lost_steps_text(*lost) + "\n" : "";
}

}  // namespace

std::string state_text(const CoreStatus& status) {
    if (status.state != MachineState::alarm) return std::string{name_of(status.state)};
    std::string text = "in alarm (" + std::string{name_of(status.alarm_cause)};
    if (status.alarm_axis < kAxisCount)
        text += " of " + std::string{name_of(static_cast<Axis>(status.alarm_axis))};
    return text + ")";
}

std::string status_text(const CoreStatus& status, const Profile* profile, const std::string& pass) {
    std::string text = "state      " + state_text(status) + "\n";
    if (status.state == MachineState::alarm) text += "remedy     " + std::string{remedy_of(status)} + "\n";
    text += latched_lost_text(status, profile);
    text += "position   ";
    for (const Axis axis : kAllAxes)
        text += (axis == Axis::r1 ? "" : ", ") + position_text(status, profile, axis);
    text += "\nhomed      " + axes_in(status.homed_mask) + "\n";
    text += "job        " + progress_text(status, pass) + "\n";
    text += formatted_status("override   %u %% of the planned feed", unsigned{status.override_percent});
    const std::uint32_t rapid_percent = rapid_override_percent(status);
    if (rapid_percent != kFullFeed_percent) text += formatted_status(", rapids %u %%", rapid_percent);
    text += "\n";
    text += outputs_text(status, profile);
    text += "tripped    " + signals_text(status.signals, kInputMask) + "\n";
    text += formatted_status(
        "core       %s, %s clock, tick %.0f us, %llu ticks, %llu missed, at most %.1f us late\n",
        status.is_simulator != 0 ? "simulated machine" : "real port",
        status.is_virtual_clock != 0 ? "virtual" : "real",
        static_cast<double>(status.period_ns) / static_cast<double>(kNsPerUs),
        static_cast<unsigned long long>(status.tick), static_cast<unsigned long long>(status.missed_ticks),
        static_cast<double>(status.max_lateness_ns) / static_cast<double>(kNsPerUs));
    text += realtime_text(status);
    text += formatted_status("alarms     %llu since the core started\n",
                             static_cast<unsigned long long>(status.alarm_count));
    return text;
}

std::string status_line(const CoreStatus& status, const std::string& pass) {
    return state_text(status) + "; job " + progress_text(status, pass) + "; tripped " +
           signals_text(status.signals, kInputMask & ~bit_of(Signal::psi_index)) + "\n";
}

}  // namespace psicarve::cli
