// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/display_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/lost_core.hpp"
#include "hmi/session/program_phrase.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

using S = MachineState;
constexpr const char* kThinSpace = "\u2009";
constexpr std::size_t kGroup = 3;
constexpr int kDecimals = 2;
constexpr long kMinute_s = 60;
constexpr long kHour_s = 3600;

std::string grouped(const std::string& digits) {
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % kGroup == 0) text += kThinSpace;
        text += digits[i];
    }
    return text;
}

AxisReadout psi_readout(std::int64_t pulses, const Profile& profile) {
    const std::int64_t per_rev = profile.psi.pulses_per_rev;
    const std::int64_t rest = ((pulses % per_rev) + per_rev) % per_rev;
    const std::int64_t turns = (pulses - rest) / per_rev;
    // 359.996 is shown as 0.00, not as an angle that does not exist.
    std::string value = number_text(deg_from_pulses(rest, per_rev), kDecimals);
    if (value == "360.00") value = "0.00";
    return {value, "°", turns == 1 ? phrase("1 turn") : phrase("%1 turns", count_text(turns))};
}

Phrase layer_of(const MachineView& machine, std::uint32_t layer_count) {
    const std::uint32_t layer = machine.status->layer + 1;
    if (layer_count == 0) return phrase("Layer %1", std::to_string(layer));
    return phrase("Layer %1 of %2", std::to_string(std::min(layer, layer_count)),
                  std::to_string(layer_count));
}

bool is_dry(const MachineView& machine) {
    return machine.status->is_dry != 0;
}

/// The place of the run in the job, or in the program.
Phrase place_of(const MachineView& machine, std::uint32_t layer_count) {
    if (machine.runs_program()) return program_place(machine.program);
    if (!is_dry(machine)) return layer_of(machine, layer_count);
    if (layer_count == 0) return phrase("Dry run");
    return phrase("Dry run, layer %1 of %2", std::to_string(std::min(machine.status->layer + 1, layer_count)),
                  std::to_string(layer_count));
}

Phrase left_text(const CoreStatus& status) {
    const std::string text = clock_text(status.seconds_left);
    return status.is_left_forecast != 0 ? phrase("about %1 left", text) : phrase("%1 left", text);
}

StateText off_text(const MachineView& machine) {
    if (machine.status->job_generation != 0)
        return {phrase("IDLE"), phrase("Not homed, job published"), Tone::idle};
    return {phrase("IDLE"), phrase("Drives off, not homed"), Tone::idle};
}

StateText ready_text(const MachineView& machine) {
    if (machine.status->job_generation != 0)
        return {phrase("READY"), phrase("Homed, job published"), Tone::run};
    return {phrase("READY"), phrase("Homed, no job"), Tone::run};
}

Phrase alarm_second(const MachineView& machine) {
    const CoreStatus& status = *machine.status;
    if (status.is_port_silent != 0) return phrase("The port does not answer");
    if (status.alarm_cause == AlarmCause::limit && status.alarm_axis < kAxisCount)
        return phrase("Limit switch %1", axis_letter(static_cast<Axis>(status.alarm_axis)));
    if (status.alarm_cause == AlarmCause::emergency_stop) return phrase("Emergency stop");
    return phrase("%1", name_of(status.alarm_cause));
}

}  // namespace

AxisReadout axis_readout(const MachineView& machine, Axis axis) {
    if (!machine.status) return {"–", "", {}};
    const std::int64_t pulses = machine.status->position_pulses[index_of(axis)];
    if (!machine.profile) return {count_text(pulses), "pulses", {}};
    if (axis == Axis::psi) return psi_readout(pulses, *machine.profile);
    const double per_mm = axis_motion(*machine.profile, axis).pulses_per_unit;
    return {number_text(mm_from_pulses(pulses, per_mm), kDecimals), "mm",
            phrase("%1 pulses", count_text(pulses))};
}

Phrase pulses_phrase(const MachineView& machine, Axis axis) {
    if (!machine.status) return {};
    const CoreStatus& status = *machine.status;
    return phrase("%1 pulses", count_text(status.position_pulses[index_of(axis)]));
}

Phrase commanded_and_actual(const MachineView& machine, Axis axis) {
    if (!machine.status || !machine.is_simulator()) return pulses_phrase(machine, axis);
    const CoreStatus& status = *machine.status;
    return phrase("%1 pulses counted; the simulated machine stands at %2",
                  count_text(status.position_pulses[index_of(axis)]),
                  count_text(status.sim_true_position_pulses[index_of(axis)]));
}

StateText state_text(const MachineView& machine, std::uint32_t layer_count) {
    if (machine.status && is_lost_at_work(machine))
        return {phrase("NO CORE"),
                machine.life == CoreLife::none ? phrase("Lost at work") : phrase("Silent at work"),
                Tone::alarm};
    if (machine.life == CoreLife::none || !machine.status)
        return {phrase("NO CORE"), phrase("Start psicarve-rtcore"), Tone::idle};
    if (machine.life == CoreLife::silent)
        return {phrase("NO CORE"), phrase("The core is silent"), Tone::idle};
    switch (machine.state()) {
        case S::off:
            return off_text(machine);
        case S::homing:
            return {phrase("HOMING"), phrase("Looking for the sensors"), Tone::run};
        case S::ready:
            return ready_text(machine);
        case S::moving:
            return {phrase("MOVING"), phrase("By hand"), Tone::run};
        case S::positioning:
            return {phrase("POSITIONING"),
                    is_dry(machine) ? phrase("Dry run: to its beginning") : phrase("To the first point"),
                    Tone::run};
        case S::waiting:
            return {phrase("WAITING"),
                    is_dry(machine) ? phrase("Dry run: at its beginning") : phrase("At the first point"),
                    Tone::run};
        case S::carving:
            if (machine.runs_program()) return {phrase("PROGRAM"), program_place(machine.program), Tone::run};
            return {is_dry(machine) ? phrase("DRY RUN") : phrase("CARVING"), layer_of(machine, layer_count),
                    Tone::run};
        case S::holding:
            return {phrase("HOLDING"), place_of(machine, layer_count), Tone::warn};
        case S::held:
            return {phrase("HELD"), place_of(machine, layer_count), Tone::warn};
        case S::finishing:
            return {phrase("FINISHING"), phrase("Heads out, spindle off"), Tone::run};
        case S::stopping:
            return {phrase("STOPPING"), phrase("Heads out, spindle off"), Tone::warn};
        case S::alarm:
            return {phrase("ALARM"), alarm_second(machine), Tone::alarm};
        case S::backing_off:
            return {phrase("BACKING OFF"), alarm_second(machine), Tone::alarm};
        case S::testing:
            return {phrase("TESTING"), phrase("One output by hand"), Tone::warn};
    }
    return {};
}

bool is_cut_short(const MachineView& machine) {
    const S state = machine.state();
    if (!machine.status || (state != S::alarm && state != S::backing_off)) return false;
    const CoreStatus& status = *machine.status;
    if (status.job_start_tick == 0 || status.job_end_tick != 0 || status.points_done >= status.points_total)
        return false;
    // A run that an earlier alarm has ended does not end again.
    return status.alarm_count < 2 ||
           status.alarms[(status.alarm_count - 2) % kAlarmHistory].tick < status.job_start_tick;
}

double done_ratio(const MachineView& machine) {
    if (!machine.status || machine.runs_program() || machine.status->points_total == 0) return -1.0;
    return static_cast<double>(machine.status->points_done) /
           static_cast<double>(machine.status->points_total);
}

bool is_left_undone(const MachineView& machine) {
    const S state = machine.state();
    if (!machine.status || !machine.is_heard() || runs_job(state)) return false;
    if (state == S::alarm || state == S::backing_off) return false;
    const CoreStatus& status = *machine.status;
    return status.points_done != 0 && status.points_done < status.points_total;
}

bool tells_of_run(const MachineView& machine, const OpenJobView& job) {
    const bool is_open = job.state == OpenJobState::empty || job.state == OpenJobState::published;
    return is_open || is_cut_short(machine) || !machine.is_heard() || runs_job(machine.state());
}

std::optional<double> planned_seconds(const MachineView& machine) {
    if (!machine.status || !machine.is_heard() || runs_job(machine.state())) return std::nullopt;
    const CoreStatus& status = *machine.status;
    const bool is_whole = status.points_total != 0 && status.points_done == 0;
    return is_whole && status.seconds_left > 0.0 ? std::optional{status.seconds_left} : std::nullopt;
}

bool is_time_about(const MachineView& machine) {
    return machine.status && machine.runs_job() && machine.status->is_left_forecast != 0;
}

Phrase time_text(const MachineView& machine, std::uint32_t layer_count) {
    if (!machine.status) return {};
    const S state = machine.state();
    if (!machine.is_heard()) return {};
    if (machine.runs_program() || machine.is_alarm_of_program) return program_line(machine.program);
    if (is_cut_short(machine)) return phrase("stopped");
    if (is_left_undone(machine)) {
        const CoreStatus& status = *machine.status;
        if (layer_count == 0) return phrase("stopped");
        return phrase("stopped in layer %1",
                      std::to_string(status.points_done * layer_count / status.points_total + 1));
    }
    const double left_s = machine.status->seconds_left;
    if (is_at_rest(state) && machine.status->points_total == 0) return phrase("No job running");
    if (left_s < 0.0 || machine.status->points_total == 0) return {};
    if (!runs_job(state)) {
        if (machine.status->points_done == machine.status->points_total) return phrase("done");
        return machine.status->points_done == 0 ? phrase("%1 planned", clock_text(left_s)) : Phrase{};
    }
    return left_text(*machine.status);
}

Phrase work_text(const MachineView& machine, std::uint32_t layer_count, std::uint32_t point_count) {
    if (!machine.status) return {};
    const CoreStatus& status = *machine.status;
    if (machine.runs_program()) {
        Phrase text = phrase("%2 · override %1 %", std::to_string(status.override_percent));
        text.inner.push_back(program_line(machine.program));
        return text;
    }
    if (!machine.runs_job() || layer_count == 0) return {};
    const std::uint64_t ticks = status.tick - std::min(status.job_start_tick, status.tick);
    const double elapsed_s =
        static_cast<double>(ticks) * static_cast<double>(status.period_ns) / static_cast<double>(kNsPerS);
    return phrase("Layer %1 / %2 · point %3 / %4 · elapsed %5 · override %6 %",
                  std::to_string(std::min(status.layer + 1, layer_count)), std::to_string(layer_count),
                  std::to_string(status.point + 1), std::to_string(point_count), clock_text(elapsed_s),
                  std::to_string(status.override_percent));
}

std::optional<std::chrono::system_clock::time_point> end_time(const MachineView& machine,
                                                              std::chrono::system_clock::time_point now) {
    const S state = machine.state();
    const bool is_on_its_way = state == S::positioning || state == S::carving || state == S::finishing;
    if (!machine.status || !machine.is_heard() || !is_on_its_way || machine.runs_program())
        return std::nullopt;
    if (machine.status->is_virtual_clock != 0 || machine.status->seconds_left < 0.0) return std::nullopt;
    const std::chrono::duration<double> left{machine.status->seconds_left};
    return now + std::chrono::duration_cast<std::chrono::system_clock::duration>(left);
}

std::optional<std::chrono::system_clock::time_point> alarm_time(const MachineView& machine) {
    const S state = machine.state();
    if (!machine.status || (state != S::alarm && state != S::backing_off)) return std::nullopt;
    const CoreStatus& status = *machine.status;
    const AlarmRecord& last = status.alarms[(status.alarm_count + kAlarmHistory - 1) % kAlarmHistory];
    if (status.is_virtual_clock != 0 || status.alarm_count == 0 || last.tick > status.tick ||
        machine.status_time.time_since_epoch().count() == 0)
        return std::nullopt;
    const auto ns = static_cast<double>(status.tick - last.tick) * static_cast<double>(status.period_ns);
    return machine.status_time - std::chrono::duration_cast<std::chrono::system_clock::duration>(
                                     std::chrono::duration<double, std::nano>{ns});
}

JobTimes job_times(const MachineView& machine, bool is_cores_job, double least_seconds,
                   const std::optional<machine::PlannedTime>& planned) {
    JobTimes times;
    // The plan of a core that has ended is no longer valid.
    const bool is_told = machine.is_heard() && machine.status && machine.status->points_total != 0;
    const bool is_running = is_told && machine.runs_job();
    if (is_told && !machine.runs_program() && machine.status->seconds_left >= 0.0 &&
        (is_running || is_cores_job)) {
        times.time = is_running ? left_text(*machine.status)
                                : phrase("%1 planned", clock_text(machine.status->seconds_left));
    } else if (planned) {
        times.time = phrase("%1 planned", clock_text(planned->carve_seconds));
    } else if (!is_running && least_seconds > 0.0) {
        times.is_least = true;
        times.time = phrase("at least %1", clock_text(least_seconds));
    }
    if (is_told && is_cores_job && machine.status->reference_seconds >= 0.0)
        times.reference = phrase("%1", clock_text(machine.status->reference_seconds));
    else if (planned && planned->reference_seconds)
        times.reference = phrase("%1", clock_text(*planned->reference_seconds));
    return times;
}

std::string number_text(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, std::fabs(value));
    const std::string digits = text;
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const bool is_zero = digits.find_first_of("123456789") == std::string::npos;
    const std::string sign = value < 0.0 && !is_zero ? "\u2212" : "";
    return sign + grouped(digits.substr(0, point)) + digits.substr(point);
}

std::string count_text(std::int64_t value) {
    const std::string digits = std::to_string(value);
    return value < 0 ? "\u2212" + grouped(digits.substr(1)) : grouped(digits);
}

std::string clock_text(double seconds) {
    const long whole = std::lround(std::clamp(seconds, 0.0, 1e9));
    char text[64];
    if (whole >= kHour_s) {
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / kHour_s, whole % kHour_s / kMinute_s,
                      whole % kMinute_s);
    } else {
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / kMinute_s, whole % kMinute_s);
    }
    return text;
}

std::string time_text_ms(std::int64_t time_ns) {
    constexpr std::int64_t kNsPerMs = 1'000'000;
    constexpr std::int64_t kMsPerS = 1000;
    const std::int64_t ms = time_ns / kNsPerMs;
    char text[8];
    std::snprintf(text, sizeof text, ".%03d", static_cast<int>(ms % kMsPerS));
    const std::int64_t whole_s = ms / kMsPerS;
    return clock_text(static_cast<double>(whole_s)) + text;
}

}  // namespace psicarve::session
