// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/path.hpp"
#include "rtcore/plan/path_stretch.hpp"
#include "rtcore/plan/program.hpp"
#include "shared/job.hpp"

namespace psicarve::plan {

/// A whole table by look-ahead, from its first point (where the machine stands) to its last: a smooth curve
/// through its points, timed as fast as the motors follow. Makes one layer's blocks at a time, the way from
/// the layer before included.
class LookaheadProgram final : public Program {
public:
    LookaheadProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job,
                     std::uint32_t first_layer = 0);

    bool next(cycle::MotionBlock& block) override;
    PlannedSoFar planned() const override { return planned_; }

private:
    PathPoint point_at(std::uint32_t layer, std::uint32_t step) const;
    void make_layer();
    void gather_points();
    void add_way_between(const PathPoint& from, const PathPoint& to);
    void add_stretch();
    void note_gaps(std::span<cycle::MotionBlock> run) const;
    void add_block(const PathPiece& piece);

    MachineLimits limits_;
    std::shared_ptr<const JobView> job_;
    StretchPlanner stretches_;
    std::uint32_t first_layer_;  ///< the machine stands at its first point
    std::uint32_t layer_;        ///< the next one to make
    std::vector<PathPoint> points_;
    std::size_t first_of_layer_ = 0;  ///< its place in points_
    std::vector<PathPiece> pieces_;
    std::vector<cycle::MotionBlock> blocks_;
    std::size_t next_ = 0;
    bool is_ended_ = false;
    PlannedSoFar planned_;
};

}  // namespace psicarve::plan
