// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "hmi/surface/job_geometry.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// All axes, in pulses and parts of one.
using Place = std::array<double, kAxisCount>;

/// The machine's measures, as far as a way needs them.
struct WayScale {
    explicit WayScale(const Profile& profile);
    /// Of a place in mm or degrees.
    double pulses(Axis axis, double place) const noexcept;

    std::array<double, kAxisCount> pulses_per_unit;  ///< by mm, psi: by degree
    std::array<double, kHeadCount> tip_mm;           ///< real radius = counted radius + this
    double pulses_per_rev;
    double rad_per_pulse;
};

/// An arc in the plane of Y and one head or both: canonical motion, no chords. Counted radius and height in
/// mm; all that is not in its plane goes along evenly, as does its radius.
struct WayArc {
    std::array<bool, kHeadCount> moves_head;
    double centre_r_mm;
    double centre_y_mm;
    double start_radius_mm;
    double end_radius_mm;
    double start_rad;  ///< of the direction from R to Y
    double sweep_rad;
};

/// How far from a way or its end a place may be: within a distance of a place that no axis is further from
/// than so many pulses.
struct WayTolerance {
    double mm = 0.0;
    double pulses = 0.0;
};

/// One way of a program, as canonical motion has it. Each head has a space of its own: along the surface (r
/// times psi), its radius, and height, in mm; r is the larger of the two ends' radii, on an arc the place's
/// own.
class ProgrammedWay {
public:
    ProgrammedWay(const WayScale& scale, const Place& from, const Place& to,
                  const std::optional<WayArc>& arc);

    const Place& from() const noexcept { return from_; }
    const Place& to() const noexcept { return to_; }
    /// The pulses at which its end is reached.
    const Positions& end_pulses() const noexcept { return end_pulses_; }
    /// The most pulses that an axis has on it, about.
    double most_pulses() const noexcept { return most_pulses_; }
    /// Of the head that goes further.
    double length_mm() const noexcept { return std::max(heads_[0].length_mm, heads_[1].length_mm); }

    struct Nearest {
        double share;  ///< of the way, 0 to 1
        double mm;     ///< the distance, less what pulses are allowed
    };
    /// The place of a head's way that is nearest to it; on an arc, near the share where it was before.
    Nearest nearest(std::size_t head, const Positions& at, const WayTolerance& tolerance,
                    double share_before) const noexcept;
    /// How far the head is that is further off the place of the way which both heads are nearest to, less
    /// what pulses are allowed [mm]; no nearer place is looked for than within the tolerance. `shares`: of
    /// the places that are nearest to each alone.
    double from_one_place_mm(const Positions& at, const WayTolerance& tolerance,
                             const std::array<double, kHeadCount>& shares) const noexcept;
    /// How far a head is from the way's end, less what pulses are allowed [mm].
    double from_end_mm(std::size_t head, const Positions& at, double pulses) const noexcept;
    /// How far back along a head's way its nearest place may come while it goes on, as a share of it.
    double back_share(std::size_t head, const WayTolerance& tolerance) const noexcept;

private:
    /// Along the surface, radius, height.
    using Space = std::array<double, 3>;
    struct Head {
        double r_mm;
        double length_mm;
        Space pulse_mm;
    };
    struct Off {
        Space mm;
        Space slack_mm;
        double distance_mm() const noexcept;
    };

    Place at(double share) const noexcept;
    Off off(std::size_t head, const Positions& at, const Place& place, double pulses) const noexcept;
    double both_mm(const Positions& at, double share, double pulses) const noexcept;
    double distance_mm(std::size_t head, const Positions& at, double share, double pulses) const noexcept;
    double share_of_line(std::size_t head, const Positions& at) const noexcept;
    double share_of_arc(const Positions& at, double share_before) const noexcept;

    const WayScale* scale_;
    Place from_;
    Place to_;
    Positions end_pulses_;
    double most_pulses_ = 1.0;
    std::optional<WayArc> arc_;
    std::array<Head, kHeadCount> heads_;
};

}  // namespace psicarve::verify
