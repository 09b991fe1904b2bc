// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {

/// The profile's.
inline constexpr double kOwnToleranceMm = 0.01;

inline const std::string kPolar = "G21 G90 F300\nG0 X40 C0 Y10\nG12.1\n";
inline const std::string kCylinder = "G21 G90 F300\nG0 X50 Y50 C0\nG7.1 C45\n";

inline std::unique_ptr<ReadProgram> drawn(const std::string& text, const Profile& profile = {}) {
    return read_program(text, machine_options(profile), &profile);
}

/// Of programs that are wrong on this machine: "LINE:COLUMN code".
inline Faults drawn_faults(const std::string& text, const Profile& profile = {}) {
    return drawn(text, profile)->faults();
}

/// Records that a line of the program makes.
inline std::vector<CanonRecord> of_line(const ReadProgram& read, std::uint64_t line) {
    std::vector<CanonRecord> found;
    for (const CanonRecord& record : read.records)
        if (record.line == line) found.push_back(record);
    return found;
}

}  // namespace psicarve::gcode
