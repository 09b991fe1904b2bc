// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

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
    /// The length by which a feed is shared out: all axes' ways, each over its top speed [s].
    double seconds_along(const Place& from, const Place& to) const noexcept;

    std::array<double, kAxisCount> pulses_per_unit;  ///< by mm, psi: by degree
    std::array<double, kAxisCount> speed_pps;
    std::array<double, kHeadCount> tip_mm;  ///< real radius = counted radius + this
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

/// A part of a way, as shares of it.
struct ShareRange {
    double least;
    double most;
};
/// Where on a way a path may have come to by now: ranges in their order, none of which touch.
using Reach = std::vector<ShareRange>;

/// One way of a program, as canonical motion has it. Each head has a space of its own: along the surface (r
/// times psi), its radius, and height, in mm; r is the radius at which the tip stands.
class ProgrammedWay {
public:
    ProgrammedWay(const WayScale& scale, const Place& from, const Place& to,
                  const std::optional<WayArc>& arc);

    const Place& from() const noexcept { return from_; }
    const Place& to() const noexcept { return to_; }
    /// The pulses at which its end is reached.
    const Positions& end_pulses() const noexcept { return end_pulses_; }
    bool is_arc() const noexcept { return arc_.has_value(); }
    /// The most pulses that an axis has on it, about, and parts of one.
    double most_pulses() const noexcept { return most_pulses_; }
    /// Of a line, the most whole ones, at least one.
    std::int64_t whole_pulses() const noexcept { return whole_pulses_; }
    /// Of the head that goes further.
    double length_mm() const noexcept { return std::max(heads_[0].length_mm, heads_[1].length_mm); }

    struct Nearest {
        double share;  ///< of the way, 0 to 1
        double mm;     ///< the distance, less what pulses are allowed
    };
    /// The place of a head's line that is nearest to it.
    Nearest nearest(std::size_t head, const Positions& at, const WayTolerance& tolerance) const noexcept;
    /// How far the head is that is further off the place of a line which both heads are nearest to, less
    /// what pulses are allowed [mm]; no nearer place is looked for than within the tolerance. `shares`: of
    /// the places that are nearest to each alone.
    double from_one_place_mm(const Positions& at, const WayTolerance& tolerance,
                             const std::array<double, kHeadCount>& shares) const noexcept;
    /// The path has come to a place: from where it may have been on an arc it goes on over all that is within
    /// the tolerance of the place, and leaves none out that is not. False: it may be on no part of the arc,
    /// and `reach` stays.
    bool go_on(std::size_t head, const Positions& at, const WayTolerance& tolerance, Reach& reach) const;
    /// The place of an arc within a range that is nearest.
    Nearest nearest_within(std::size_t head, const Positions& at, const WayTolerance& tolerance,
                           const ShareRange& range) const noexcept;
    /// The last place of an arc within a range that is within the tolerance, if any.
    std::optional<double> last_near(std::size_t head, const Positions& at, const WayTolerance& tolerance,
                                    const ShareRange& range) const noexcept;
    /// The same as from_one_place_mm() on an arc, where both are within a range.
    double from_one_place_within_mm(const Positions& at, const WayTolerance& tolerance,
                                    const ShareRange& range) const noexcept;
    /// How far a head is from a place of the way, less what pulses are allowed [mm].
    double from_mm(const Place& place, std::size_t head, const Positions& at, double pulses) const noexcept;
    /// At how many places of arcs go_on() and last_near() have looked, all in all.
    std::uint64_t places_looked_at() const noexcept { return places_looked_at_; }
    /// How far back along a head's way its nearest place may come while it goes on, as a share of it; a line
    /// is as long as it is for the tip's radius there.
    double back_share(std::size_t head, const Positions& at, const WayTolerance& tolerance) const noexcept;

private:
    /// Along the surface, radius, height.
    using Space = std::array<double, 3>;
    struct Head {
        double length_mm;  ///< r: the larger of the two ends' radii
        Space pulse_mm;    ///< r: the larger one
    };
    struct Off {
        Space mm;
        Space slack_mm;
        double distance_mm() const noexcept;
        /// All that is off by no more than this besides is within the slack.
        double room_mm() const noexcept;
    };
    struct Near {
        bool is_near;
        double next_share;  ///< up to there all is as this place is
    };

    Place at(double share) const noexcept;
    Space pulse_mm(std::size_t head, const Positions& at) const noexcept;
    Off off(std::size_t head, const Positions& at, const Place& place, double pulses) const noexcept;
    double both_mm(const Positions& at, double share, double pulses) const noexcept;
    double distance_mm(std::size_t head, const Positions& at, double share, double pulses) const noexcept;
    double share_of_line(std::size_t head, const Positions& at) const noexcept;
    double share_of_arc(const Positions& at, double share_before) const noexcept;
    double arc_length_mm(std::size_t head, const Positions& at) const noexcept;
    Near near_at(std::size_t head, const Positions& at, const WayTolerance& tolerance, double share,
                 double length_mm) const noexcept;

    const WayScale* scale_;
    Place from_;
    Place to_;
    Positions end_pulses_;
    double most_pulses_ = 0.0;
    std::int64_t whole_pulses_ = 1;
    std::optional<WayArc> arc_;
    std::array<Head, kHeadCount> heads_;
    /// The share of one turn, where each turn goes over the same places: a circle, and nothing else moves.
    /// More than 1: they do not, or there is but one.
    double turn_share_ = 2.0;
    mutable std::uint64_t places_looked_at_ = 0;
};

}  // namespace psicarve::verify
