// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// The strokes as they look: a dashed one becomes its dashes, each a stroke that stays open; a dash without
/// length is a point, twice. Refuses more dashes than a drawing may have points.
Result<std::vector<Path>> seen_strokes(std::vector<Path> paths, const std::string& file);

}  // namespace psicarve::flat
