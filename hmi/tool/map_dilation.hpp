// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hmi/slice/slicer.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/base/result.hpp"

namespace psicarve::tool {

/// A surface by samples: row after row, columns at 2 pi i / column_count, rows `row_pitch` apart.
struct SampledRadii {
    std::size_t row_count = 0;
    std::size_t column_count = 0;
    double row_pitch = 0.0;
    std::span<const float> radius;  ///< 0: no surface
};

/// The tip's radius in each sample's direction and height,
///
///     allowance + max of r cos(D) - h(s),   s = hypot(r sin(D), y - y0) <= R,   |D| < 90 degrees
///
/// over all samples (r, D from the column, y) alone, at least 0: fast for every mesh, and too deep by the
/// surface's bulge between samples, which the allowance covers. In single precision: to about 1e-6 of the
/// radii, and where a tool's rim touches to the square root of that. Requires a tool that has a size, at
/// least one row and 4 columns. ErrorCode::cancelled, out_of_room.
Result<std::vector<float>> dilated(const SampledRadii& surface, const Tool& tool, double allowance,
                                   const slice::SliceOptions& options);

/// An allowance for the bulge of a smooth surface between its samples under a ball or a flat tool: by its
/// curvature, and how a ball sinks in between. Where a surface steps from one sample to the next no allowance
/// suffices; such places are left out. Enough for this share of the samples; 1: for all.
double sample_allowance(const SampledRadii& surface, const Tool& tool, double share);

}  // namespace psicarve::tool
