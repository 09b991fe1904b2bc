// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rtcore/plan/curve_part.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/speed_profile.hpp"

namespace psicarve::plan {

/// The speeds of a path from rest to rest whose end is not known yet, part by part. Of a part they are
/// settled once the one behind it is decided:
///
///     x |   settled      ____ planned ____          x = (du/dt)^2; settled as if the path came to rest where
///       |    ___________/                 \         it is decided. So the speed that a part ends with is one
///       |   /      rest profile \          \        from which the next one can come to rest within itself.
///       |  /                      \          \      Nothing that comes later changes what is settled.
///       +-|-----------------------|-----------|-- u
///         part held               part behind
///
/// A settled part also has a rest profile: as fast as the axes can at twice the feed, from a begin no lower
/// than any plan's to a rest at its end.
class RecedingSpeeds {
public:
    /// `limits` outlive it. `accel` as the curve's.
    RecedingSpeeds(const MachineLimits& limits, const Lanes& accel) : limits_(&limits), timing_(accel) {}

    bool is_empty() const { return !held_.has_value(); }
    /// Decided: goes on where the part held ends, or is the first from a rest.
    const CurvePart& held() const { return *held_; }
    /// Pieces of the part that was held until now; now the next one is.
    void settle(CurvePart next, std::vector<PathPiece>& pieces);
    void hold(CurvePart first);
    /// Pieces of the part held: it rests at its end.
    void end(std::vector<PathPiece>& pieces);
    /// Where the pieces made so far end. Where corners are rounded that is no point of the path.
    const Pulses4& end_pulses() const { return end_pulses_; }

private:
    using Speeds = std::array<std::vector<double>, kTimingCount>;

    void gather(const CurvePart* behind);
    void solve();
    void solve_rest();
    void add_pieces(bool is_open, std::vector<PathPiece>& pieces);

    const MachineLimits* limits_;
    SpeedProfile timing_;
    std::optional<CurvePart> held_;
    Timings begin2_{};      ///< of the part held
    Pulses4 end_pulses_{};  ///< where it begins
    std::vector<PathCell> cells_;
    Speeds bound2_;
    std::array<std::vector<InnerSpeeds2>, kTimingCount> inner2_;
    Speeds speed2_;
    std::vector<double> rest2_;
};

}  // namespace psicarve::plan
