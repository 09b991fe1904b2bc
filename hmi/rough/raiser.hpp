// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/rough/rings.hpp"
#include "shared/job/outside.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::rough {

/// A value for each head and point of a layer, such as its radii.
template <typename T>
using ByPoint = std::array<std::vector<T>, kHeads>;

/// Raises heads out of the blank where they have nothing to cut, if that is sooner: outside there is no feed
/// (shared/job/outside.hpp). It only moves points outwards, so a head touches nothing that it would not have
/// touched.
///
/// A run of clear points keeps its first and last radius. From each of them the head goes out, or comes in,
/// with 7/10 of its acceleration a and 9/10 of its top speed v, while the table turns as the feed lets it
/// there:
///
///     h >= v^2/a:  T = h/v + v/a         else  T = 2 sqrt(h/a)          h: how far out it has to go
///
/// A run that is too short for both ways stays as it is. A layer's time is estimated from the table alone:
/// each line at the least of its own top speed, the heads' and the feed of those that are not outside, with
/// its acceleration from line to line. The heads are raised if that saves a twentieth of a second.
class Raiser {
public:
    /// `known_blank_mm`: no material is further out; 0: not known, and nothing is raised.
    Raiser(const Rings& rings, const Profile& profile, double feed_mm_s, double known_blank_mm);

    /// `cuts`: where a head's tool should touch, or the way from or to such a point. Returns the time saved
    /// in the layer [s]; 0: nothing was raised.
    double raise(ByPoint<std::int32_t>& radii, const ByPoint<char>& cuts) const;
    /// The time in which the table turns through a layer from rest to rest [s], as above.
    double seconds(const ByPoint<std::int32_t>& radii) const;

private:
    struct Run {
        std::size_t first;
        std::size_t end;
        std::array<bool, kHeads> of_head;
    };
    std::vector<Run> runs(const ByPoint<char>& cuts) const;
    bool lift(std::vector<std::int32_t>& radii, std::size_t head, const Run& run) const;
    double line_speed(const ByPoint<std::int32_t>& radii, std::size_t line) const;
    bool changes_outside(const ByPoint<std::int32_t>& radii, std::size_t point) const;

    const Rings& rings_;
    HeadsOutside outside_;
    std::array<AxisMotion, kHeads> motion_;
    double line_rad_;
    double feed_mm_s_;
    double speed_rad_s_;
    double start_stop_rad_s_;
    double accel_rad_s2_;
    bool stops_at_changes_;  ///< the planner by angle slows to start speed there
};

}  // namespace psicarve::rough
