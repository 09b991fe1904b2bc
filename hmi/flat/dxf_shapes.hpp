// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/dxf_text.hpp"

namespace psicarve::flat {

/// From the coordinates of an entity's own plane (its extrusion direction) to the drawing, seen from above.
Affine dxf_plane(const DxfElement& element);

/// A vertex and the bulge of the way to the next one: the tangent of a quarter of its angle.
struct DxfVertex {
    Point point;
    double bulge = 0.0;
};
void draw_bulges(const std::vector<DxfVertex>& vertices, bool is_closed, PathMaker& maker);

/// Draws one element; false for other types. `placement`: of the drawing or block that holds it.
bool draw_dxf_shape(const DxfElement& element, const Affine& placement, PathMaker& maker);

/// Draws a SPLINE that has fit points alone: the cubic through them whose parameter is the chords' length,
/// with its end tangents if it has them. False when there are less than two.
bool draw_dxf_fit_spline(const DxfElement& element, const Affine& placement, PathMaker& maker);

/// Draws a SPLINE by its control points; false when its knots, degree and points do not belong together.
bool draw_dxf_spline(const DxfElement& element, const Affine& placement, PathMaker& maker);

}  // namespace psicarve::flat
