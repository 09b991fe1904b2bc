// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "hmi/machine/planned_time.hpp"
#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// The meaning of a colour; each has an icon of its own shape.
enum class Tone : std::uint8_t { idle, run, warn, alarm, replay };

/// One axis in large digits. Without a known profile positions are shown in pulses.
struct AxisReadout {
    std::string value;  ///< "21.54"
    std::string unit;   ///< "mm", "°" or "pulses"
    Phrase second;      ///< psi: "157 turns"; "8 617 pulses"
};
AxisReadout axis_readout(const MachineView& machine, Axis axis);
/// "8 617 pulses"; empty where the position is not known.
Phrase pulses_phrase(const MachineView& machine, Axis axis);
/// For a simulated machine also the true position, which only it knows: stepper motors do not report one.
Phrase commanded_and_actual(const MachineView& machine, Axis axis);

struct StateText {
    Phrase word;    ///< "CARVING"
    Phrase second;  ///< "Layer 315 of 500"
    Tone tone = Tone::idle;
};
StateText state_text(const MachineView& machine, std::uint32_t layer_count);

/// The latched alarm ended the run of a job: not an alarm that came after the run, nor one at rest.
bool is_cut_short(const MachineView& machine);

/// The share of the job that is carved; negative: there is none, or a program runs.
double done_ratio(const MachineView& machine);
/// "12:38 left", "about 12:38 left", "stopped", "stopped in layer 315", "Program, line 12" ... `layer_count`:
/// of the core's job; 0: not known.
Phrase time_text(const MachineView& machine, std::uint32_t layer_count = 0);
/// Not all of the run is planned yet: part of its time is a forecast.
bool is_time_about(const MachineView& machine);
/// The last run ended before its last point; false where an alarm shows that itself.
bool is_left_undone(const MachineView& machine);
/// Whether the present or last run belongs to the open job; true while the machine works.
bool tells_of_run(const MachineView& machine, const OpenJobView& job);
/// The whole accepted job that was not begun, as the core plans it [s].
std::optional<double> planned_seconds(const MachineView& machine);

/// "Layer 315 / 500 · point 212 / 500 · elapsed 21:32 · override 100 %" while a job runs,
/// "Program, line 12 · override 100 %" while a program does; else nothing.
Phrase work_text(const MachineView& machine, std::uint32_t layer_count, std::uint32_t point_count);
/// When the running job will be done, by the computer's clock; nothing when that is not known: none runs, it
/// is on hold, or the core's clock is virtual.
std::optional<std::chrono::system_clock::time_point> end_time(const MachineView& machine,
                                                              std::chrono::system_clock::time_point now);
/// When the latched alarm stopped the machine, by the computer's clock; nothing when there is none, or the
/// core's clock is virtual.
std::optional<std::chrono::system_clock::time_point> alarm_time(const MachineView& machine);

/// The duration of the job that the operator looks at.
struct JobTimes {
    Phrase time;            ///< "2:04 planned", "1:20 left", "about 1:20 left"; empty when not known
    Phrase reference;       ///< T_ref of the whole job
    bool is_least = false;  ///< not planned yet: only what feed and top speeds allow
};
/// `is_cores_job`: it is the one that the core accepted. `least_seconds`: 0 when not known. `planned`: by a
/// core of our own; the machine's own value comes first.
JobTimes job_times(const MachineView& machine, bool is_cores_job, double least_seconds,
                   const std::optional<machine::PlannedTime>& planned = {});

/// A number with `decimals` digits behind a point, and a thin space per thousand. Requires 0 <= decimals <=
/// 6.
std::string number_text(double value, int decimals);
std::string count_text(std::int64_t value);
inline std::string counted(std::uint64_t count) {
    return count_text(static_cast<std::int64_t>(count));
}
/// "m:ss" below one hour and "h:mm:ss" above.
std::string clock_text(double seconds);
/// The same with milliseconds: "14:04.812". Not rounded up.
std::string time_text_ms(std::int64_t time_ns);

}  // namespace psicarve::session
