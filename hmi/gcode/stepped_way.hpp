// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/canon.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::gcode {

/// An arc that the core can step along, seen with its head's axis to the right and y upwards.
struct SteppedArc {
    Axis head = Axis::r1;
    std::array<double, 2> centre_mm{};  ///< a place that the axes have, near the program's centre
    bool is_counterclockwise = true;
    int whole_turns = 0;
    double rest_rad = 0.0;   ///< that it turns behind them; 0: nothing
    double sweep_rad = 0.0;  ///< all of it, > 0
};

/// Which ways of a program run by point-by-point comparison, where the profile says so: with a feed, not
/// drawn in the cross-section or on the unrolled cylinder, and of one head, of Y, or of both.
class SteppedWays {
public:
    explicit SteppedWays(const Profile& profile) noexcept;

    /// The axes of a line, by Axis; 0: it is none. `letters`: those that may move.
    std::uint8_t line_axes(const CanonRecord& record, AxisMask letters) const noexcept;
    /// Nothing: the arc stays chords. So it does as a helix, where psi or a second head moves with it, where
    /// its head and y differ in pulses per mm, where its ends are not, to a pulse, as far from the centre as
    /// each other, where ends that differ are nearer to each other than 16 pulses, where its radius
    /// is less, and within two pulses of where an axis may not be.
    std::optional<SteppedArc> arc(const CanonRecord& record) const noexcept;
    /// Why a way with a feed is none, though the profile asks for it: one of a few texts that are translated
    /// where they are shown. Empty: it is one, or none was asked for, or it cannot be told as a place is not
    /// known.
    const char* why_not(const CanonRecord& record) const noexcept;

private:
    const char* find_arc(const CanonRecord& record, SteppedArc& found) const noexcept;
    const char* why_no_line(const CanonRecord& record) const noexcept;
    bool has_room(const CanonRecord& record, Axis head) const noexcept;

    bool is_on_;
    AxisLetters letters_;
    std::array<AxisMotion, kAxisCount> axes_;
    std::array<std::int64_t, 2> core_pulses_;
};

/// Letters that a canonical record moves, or whose place it sets.
AxisMask changed_letters(const CanonRecord& record) noexcept;

}  // namespace psicarve::gcode
