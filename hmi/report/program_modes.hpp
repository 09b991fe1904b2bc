// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "shared/machine/program_modes.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::report {

// What holds for a program that runs, as its writer tells it. Nothing of it is believed: a code that is none
// and a number that is none are left out.

/// "G1 G17 G21 G90 G94 G54 G64 M3 M9"; empty: not known.
std::string codes_text(const ProgramModes& modes);
/// "G54"; empty: not known.
std::string system_text(const ProgramModes& modes);
/// "600", "0.1": a number as it is written in a program.
std::string word_text(double value);
/// Nothing: no program has it.
std::optional<double> shown_number(double value) noexcept;
std::optional<std::int64_t> shown_tool(const ProgramModes& modes) noexcept;
/// "F 600, S 0, T 2", those of them that are numbers; empty: none is.
std::string words_text(const ProgramModes& modes, std::string_view between);
/// Whether it is told of the way that the machine is at: not so for a moment after it has gone on, and for
/// good once the writer is gone.
bool is_at_hand(const ProgramModes& modes, const ProgramStatus& status) noexcept;
bool has_numbers(const std::array<double, kAxisCount>& values) noexcept;
/// From where the machine stands to the end of the way at hand, by Axis [mm, degrees]; nothing: not known, or
/// it goes there no more, as after a stop.
std::optional<std::array<double, kAxisCount>> to_go(const ProgramModes& modes, const ProgramStatus& status,
                                                    const CoreStatus& machine, const Profile& profile);

}  // namespace psicarve::report
