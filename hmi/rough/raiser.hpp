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

/// A layer's radii, or what else there is by head and point.
template <typename T>
using ByPoint = std::array<std::vector<T>, kHeads>;

/// Raises heads out of the blank where they have nothing to cut, if that is sooner: outside there is no feed
/// (shared/job/outside.hpp). Only ever outwards, so a head touches nothing that it would not have touched.
///
/// A run of clear points keeps its first and last radius. From each of them the head goes out, or comes in,
/// with 7/10 of its acceleration a and 9/10 of its top speed v, while the table turns as the feed lets it
/// there:
///
///     h >= v^2/a:  T = h/v + v/a         else  T = 2 sqrt(h/a)          h: how far out it has to go
///
/// A run that is too short for both ways stays as it is. Of a layer's time is looked at what the table needs:
/// each line at the least of its own top speed, the heads' and the feed of those that are not outside, with
/// its acceleration from line to line. The heads are raised if that is a twentieth of a second less.
class Raiser {
public:
    /// `known_blank_mm`: no material is further out; 0: not known, and nothing is raised.
    Raiser(const Rings& rings, const Profile& profile, double feed_mm_s, double known_blank_mm);

    /// `cuts`: where a head's tool is to touch, or the way from or to such a point. How much sooner the layer
    /// is done [s]; 0: nothing was raised.
    double raise(ByPoint<std::int32_t>& radii, const ByPoint<char>& cuts) const;
    /// What the table needs to turn through a layer from rest to rest [s], as above.
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
    bool stops_at_changes_;  ///< the planner by angle comes to start speed there
};

}  // namespace psicarve::rough
