// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/tool/map_dilation.hpp"

namespace psicarve::tool {

/// So much wider that what the tool covers between places, this one covers at one of those beside it.
Tool widened(const SampledRadii& surface, Tool tool, Stride stride);

/// Tips at the places between those that were searched, every `stride`th and the last row, by the tool that
/// these were searched with: nowhere less than a search would have found for the tool it was widened from.
void fill_gaps(const SampledRadii& surface, const Tool& searched, Stride stride, std::vector<float>& tips);

}  // namespace psicarve::tool
