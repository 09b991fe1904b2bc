// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "hmi/flat/drawing.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// The strokes and outlines of an SVG picture, in mm: paths, lines and basic shapes under their transforms,
/// <use> and <symbol> included. Text, pictures, markers and clipping are left out with a warning.
/// Source: SVG 1.1 (second edition), with SVG 2's plain href. `scale` multiplies every length.
Result<Drawing> read_svg(std::string_view text, const std::string& file, double scale);

}  // namespace psicarve::flat
