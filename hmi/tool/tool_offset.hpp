// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/slicer.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/base/result.hpp"

namespace psicarve::tool {

/// The places for which a head's tip is calculated in one turn: `direction_rad` are its columns, ascending; a
/// column's rows are heights in ascending order, placed file units.
struct TipPlaces {
    std::span<const double> direction_rad;
    std::size_t row_count = 0;
    /// One list for all columns, or, where rows rise during a turn, a list for each column, one after the
    /// other.
    std::span<const double> heights;
};

/// The tip's radius at every place [column * row_count + row], file units: the least at which the tool does
/// not enter the model,
///
///     max of r cos(D) - h(s),   s = hypot(r sin(D), y - y0) <= R,   |D| < 90 degrees
///
/// over all points (r, D from the column, y) of the surface, exactly: a tool touches corners, edges or
/// facets. 0: nothing is within its reach there. Tool lengths in file units. ErrorCode::cancelled,
/// out_of_room.
Result<std::vector<double>> tip_radii(const model::Mesh& mesh, const slice::Placement& placement,
                                      const Tool& tool, const TipPlaces& places,
                                      const slice::SliceOptions& options);

}  // namespace psicarve::tool
