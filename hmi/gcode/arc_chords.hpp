// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/gcode/canon.hpp"

namespace psicarve::gcode {

/// An arc's chords may be off by this share of its tolerance, and their corners be passed within the rest: a
/// circle that touches the chords passes their corners within the first share, so that the rest leaves room.
inline constexpr double kChordShare = 0.25;

/// An arc or a helix as points on it, joined by straight chords. All axes that are not in its plane move
/// along evenly; where its radii differ so does the radius.
class ArcChords {
public:
    /// No chord is further than `chord_mm` off the arc (its sagitta). Requires an arc, and chord_mm > 0.
    ArcChords(const CanonRecord& arc, double chord_mm) noexcept;

    std::uint64_t count() const noexcept { return count_; }
    /// Where chord `number`, from 1 to count(), ends. The last one ends exactly where the arc does.
    Position end_of(std::uint64_t number) const noexcept;

private:
    Position start_;
    Position end_;
    const Plane* plane_;
    double centre_first_mm_;
    double centre_second_mm_;
    double start_radius_mm_;
    double end_radius_mm_;
    double start_rad_;
    double sweep_rad_;
    std::uint64_t count_;
};

}  // namespace psicarve::gcode
