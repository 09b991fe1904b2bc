// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hmi/flat/drawing.hpp"

namespace psicarve::flat {

/// Cuts a counter-clockwise ring without crossings into n - 2 triangles, likewise turned; corners are indices
/// into it. Of a ring that rounding has made cross itself every edge is used all the same.
std::vector<std::array<std::size_t, 3>> triangles_of(const std::vector<Point>& ring);

}  // namespace psicarve::flat
