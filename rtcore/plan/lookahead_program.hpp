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
#include "rtcore/plan/table_program.hpp"
#include "shared/job/job.hpp"

namespace psicarve::plan {

/// A whole table by look-ahead: a smooth curve through its points, timed as fast as the motors follow. A
/// layer is made with the way from the layer before, and whole, wherever in it the carving begins. Of a
/// spiral so many rows are made at once, counted from row 0 wherever the carving begins: so the cuts, and the
/// order of all pulses, do not depend on where that is, nor on where it ends.
class LookaheadProgram final : public TableProgram {
public:
    LookaheadProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job, LayerSpan layers = {});

private:
    void make_layers() override;
    void gather_layer();
    void add_fastest_link(const PathPoint& from, const PathPoint& to);
    double seconds_of(std::span<const PathPoint> way);
    void gather_rows(std::uint32_t end);
    void add_stretches(std::size_t first, std::size_t last);
    void add_stretch();
    void add_block(const PathPiece& piece);
    void begin_in_between();
    void end_in_between();

    StretchPlanner stretches_;
    std::vector<PathPoint> points_;
    std::size_t first_of_layer_ = 0;  ///< its place in points_
    std::vector<PathPiece> pieces_;
};

}  // namespace psicarve::plan
