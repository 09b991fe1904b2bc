// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "hmi/session/machine_sight.hpp"
#include "hmi/session/phrase.hpp"

namespace psicarve::session {

/// What a colour says; each has an icon of its own shape.
enum class Tone : std::uint8_t { idle, run, warn, alarm, replay };

/// One axis in large digits. Without a known profile positions are shown in pulses.
struct AxisReadout {
    std::string value;  ///< "21.54"
    std::string unit;   ///< "mm", "°" or "pulses"
    Phrase second;      ///< psi: "157 turns"; "8 617 pulses"
};
AxisReadout axis_readout(const MachineSight& machine, Axis axis);

struct StateText {
    Phrase word;    ///< "CARVING"
    Phrase second;  ///< "Layer 315 of 500"
    Tone tone = Tone::idle;
};
StateText state_text(const MachineSight& machine, std::uint32_t layer_count);

/// How much of the job is carved; negative: there is none.
double done_ratio(const MachineSight& machine);
/// "12:38 left", "stopped", "" ...
Phrase time_text(const MachineSight& machine);

/// How long the job takes that the operator looks at.
struct JobTimes {
    Phrase time;            ///< "2:04 planned", "1:20 left"; nothing when it is not known
    Phrase reference;       ///< T_ref of all of it
    bool is_least = false;  ///< nobody has planned it yet: what feed and top speeds allow
};
/// `is_cores_job`: it is the one that the core accepted. `least_seconds`: 0 when not known.
JobTimes job_times(const MachineSight& machine, bool is_cores_job, double least_seconds);

/// With so many decimals, a point, and a thin space per thousand. Requires 0 <= decimals <= 6.
std::string number_text(double value, int decimals);
std::string count_text(std::int64_t value);
/// "m:ss" below one hour and "h:mm:ss" above.
std::string clock_text(double seconds);
/// The same with milliseconds: "14:04.812". Not rounded up.
std::string time_text_ms(std::int64_t time_ns);

}  // namespace psicarve::session
