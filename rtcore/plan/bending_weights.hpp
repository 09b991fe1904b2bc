// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "rtcore/plan/path.hpp"
#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/speed_profile.hpp"

namespace psicarve::plan {

/// Where a timed curve had better bend less, and where it may bend more: weights of its cells for another
/// fit. By axis, in the middle of each cell, with x = (du/dt)^2:
///
///     weight = ((1 + share) / 2)^2        share = |q'' * x + q' * x' / 2| / a_k, at most 1
///
/// The curve of least bending bends most in the midst of a turn, and that alone decides how fast all of the
/// turn is passed. With these weights, between 1/4 and 1, it bends more evenly. The result is the share of
/// the time in which an axis is at its acceleration, or nearly: no more than that can be gained from.
/// It is none where nothing bends to speak of: an axis alone is never faster than on the straight way.
double weigh_bending(std::span<const PathCell> cells, std::span<const double> speed2, const Lanes& accel,
                     std::vector<Lanes>& weights);

/// What has become of a curve.
struct FittedTimes {
    bool is_within = false;  ///< its tube, everywhere
    Timings seconds{};
};

/// Whether a curve that bends evenly is to replace the one of least bending: never if it is not within its
/// tube; otherwise if the other one is not, or if it is faster by what the cuts of more bending cost, and not
/// slower at twice the feed.
bool is_worthwhile(const FittedTimes& even, const FittedTimes& least_bent) noexcept;

}  // namespace psicarve::plan
