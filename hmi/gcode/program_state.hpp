// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace psicarve::gcode {

/// What is known of a parameter that the machine sets itself.
struct StateAnswer {
    enum class Kind : std::uint8_t {
        none,      ///< the program's own parameter
        not_read,  ///< LinuxCNC has it, this machine has nothing that it could tell
        value,
    };
    Kind kind = Kind::none;
    double value = 0.0;
    bool is_certain = true;  ///< false: of a place that the program has not set yet
};

/// Answers for the parameters that a program may read of the machine: places, offsets, modes.
class ProgramState {
public:
    virtual ~ProgramState() = default;
    virtual StateAnswer numbered(std::uint32_t number) const = 0;
    /// In small letters, without blanks.
    virtual StateAnswer named(std::string_view name) const = 0;
};

}  // namespace psicarve::gcode
