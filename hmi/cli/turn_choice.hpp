// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Reads --rotate ("30" about the axis that stands upright, "90,0,30" about x, y, z) and --mirror ("x");
/// empty: not given.
Result<model::MeshTurn> mesh_turn(const std::string& rotate, const std::string& mirror, slice::Up up);

}  // namespace psicarve::cli
