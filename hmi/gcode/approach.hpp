// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/canon.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::gcode {

/// What the program has come to when a line begins: what a run from there does first.
struct Approach {
    std::array<double, kAxisCount> place{};  ///< mm, degrees
    std::uint8_t placed = 0;                 ///< bit of each axis that is brought to its place
    bool is_spindle_on = false;
    SwitchedOutputs outputs_on = 0;
    bool is_reached = false;  ///< the program comes to that line
    bool is_needed() const noexcept { return placed != 0 || is_spindle_on || outputs_on != 0; }
    bool brings(Axis axis) const noexcept { return (placed >> index_of(axis) & 1U) != 0; }
};

/// Of a program that is to begin with such a line.
Error ends_before(std::uint64_t line);

/// Notes what stands before a line.
class ApproachFinder : public CanonSink {
public:
    ApproachFinder(const Profile& profile, std::uint32_t from_line) noexcept
        : letters_(profile.gcode), wired_outputs_(wired_outputs(profile)), from_line_(from_line) {}

    void begin_line(const ReachedLine& line) override;
    void take(const CanonRecord& record) override;
    const Approach& found() const noexcept { return found_; }

private:
    AxisLetters letters_;
    SwitchedOutputs wired_outputs_;
    std::uint32_t from_line_;
    Approach found_;
};

}  // namespace psicarve::gcode
