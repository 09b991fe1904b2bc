// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "hmi/flat/drawing.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// The lines of an ASCII DXF file in mm, seen from above: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE
/// with bulges, SPLINE, and blocks where they are inserted. Layers that are off or frozen, and paper space,
/// are not drawn; a warning names other kinds of entities. `scale` multiplies every length.
/// Source: Autodesk's DXF reference (group codes, arbitrary axis algorithm).
Result<Drawing> read_dxf(std::string_view text, const std::string& file, double scale);

}  // namespace psicarve::flat
