// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"

namespace psicarve::slice {

/// Counts of the walls of a model that rays from the axis meet in some directions or at some heights.
struct WallCount {
    std::uint64_t walls = 0;
    std::uint64_t hidden = 0;  ///< behind another one in the same direction
    std::uint64_t rays = 0;
    std::uint64_t open = 0;  ///< rays whose walls cannot belong to a closed body

    double hidden_share() const noexcept {
        return walls > 0 ? static_cast<double>(hidden) / static_cast<double>(walls) : 0.0;
    }
    double open_share() const noexcept {
        return rays > 0 ? static_cast<double>(open) / static_cast<double>(rays) : 0.0;
    }
};

/// Where a radial tool cannot reach a model, and where its mesh is open.
struct HiddenParts {
    std::vector<WallCount> sectors;  ///< of equal width, as many as make a turn, from direction 0 on
    std::vector<WallCount> layers;   ///< at the heights asked for

    /// Neighbours whose `share` is above `least`, from `begin` to one past the last; a run of sectors may
    /// pass direction 0.
    struct Run {
        std::size_t begin;
        std::size_t end;
        double share;  ///< over the whole run
    };
    using Share = double (WallCount::*)() const noexcept;
    static std::vector<Run> runs(const std::vector<WallCount>& counts, Share share, double least,
                                 bool is_round);
};

/// Counts along rays half a degree off whole ones, ten in each of 36 sectors. `heights`: ascending, placed
/// file units.
Result<HiddenParts> hidden_parts(const model::Mesh& mesh, const Placement& placement,
                                 const std::vector<double>& heights, const SliceOptions& options);

}  // namespace psicarve::slice
