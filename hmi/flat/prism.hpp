// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/flat/outline.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// The body whose every layer is the outline, from height 0 to `height_mm`; closed, with the area's centroid
/// as its centre.
Result<model::Mesh> prism_of(const Outline& outline, double height_mm, const std::string& format,
                             const std::string& file);

}  // namespace psicarve::flat
