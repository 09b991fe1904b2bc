// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hmi/flat/drawing.hpp"

namespace psicarve::flat {

/// Cuts a counter-clockwise ring without crossings into n - 2 triangles of the same orientation; corners are
/// indices into it. Every edge is used even where rounding has made the ring cross itself.
std::vector<std::array<std::size_t, 3>> triangles_of(const std::vector<Point>& ring);

}  // namespace psicarve::flat
