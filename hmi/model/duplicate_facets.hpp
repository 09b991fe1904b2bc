// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/model/mesh.hpp"

namespace psicarve::model {

/// Removes every repeated facet, and returns how many those were. A facet that lies upon another one the
/// other way round is a wall between two bodies and stays, unless nearly all facets are such pairs: then the
/// model was written with both sides of its surface, and one side is removed.
std::uint64_t drop_duplicates(TriangleList& triangles);

}  // namespace psicarve::model
