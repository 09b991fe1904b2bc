// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/layer_scan.hpp"
#include "hmi/slice/placement.hpp"
#include "shared/base/result.hpp"

namespace psicarve::slice {

/// Called on the caller's thread with the share of the work that is done, 0 to 1; false ends the work.
using Progress = std::function<bool(double done_ratio)>;

/// Called once for each layer, in no fixed order, from `thread_count` threads.
using LayerSink = std::function<void(const LayerSection&)>;

struct SliceOptions {
    unsigned thread_count = 1;  ///< the result is the same, bit for bit, for any number
    Progress progress;

    /// For a part of the work, `share` of the whole, that begins at `begin`. This object outlives it.
    SliceOptions part(double begin, double share) const {
        SliceOptions options{thread_count, {}};
        if (progress)
            options.progress = [this, begin, share](double done) { return progress(begin + share * done); };
        return options;
    }
};

/// r(theta, h) of a mesh at the given heights (ascending, placed file units) and directions, layer by layer.
Result<std::vector<LayerTotals>> slice_layers(const model::Mesh& mesh, const Placement& placement,
                                              std::span<const double> heights, const Directions& directions,
                                              const LayerSink& sink, const SliceOptions& options);

/// The rows of a spiral through the layers' heights, see SpiralScan: a ring at the first, then a row that
/// rises from each height to the next, then a ring at the last (of one height: one ring). Requires an even
/// number of directions.
Result<std::vector<LayerTotals>> slice_spiral(const model::Mesh& mesh, const Placement& placement,
                                              std::span<const double> heights, const Directions& directions,
                                              const LayerSink& sink, const SliceOptions& options);

/// All of r(theta, h) at once: radius[layer * direction_count + direction], file units, 0 where nothing is.
struct RadialMap {
    std::size_t direction_count = 0;
    std::vector<double> radius;
    std::vector<LayerTotals> layers;
};
Result<RadialMap> radial_map(const model::Mesh& mesh, const Placement& placement,
                             std::span<const double> heights, const Directions& directions,
                             const SliceOptions& options);

/// The share of the surface (all walls) that lies behind others; 0 where no wall does.
double undercut_share(std::span<const LayerTotals> layers);

/// Heights of the layers: i at bottom + (i + 1/2) * height / count.
std::vector<double> layer_heights(double bottom, double height, std::size_t count);

}  // namespace psicarve::slice
