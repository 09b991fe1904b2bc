// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/map_dilation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "shared/base/units.hpp"

namespace psicarve::tool {
double sample_allowance(const SampledRadii& surface, const Tool& tool, double share) {
    const std::size_t columns = surface.column_count;
    std::vector<double> asked;
    for (std::size_t row = 1; row + 1 < surface.row_count; ++row) {
        const float* const at = surface.radius.data() + row * columns;
        for (std::size_t column = 0; column < columns; ++column) {
            const double here = at[column];
            const double left = at[(column + columns - 1) % columns];
            const double right = at[(column + 1) % columns];
            const double below = *(at + column - columns);
            const double above = at[column + columns];
            const double round = 2.0 * kPi * here / static_cast<double>(columns);
            const double bend = std::abs(left + right - 2.0 * here) + std::abs(above + below - 2.0 * here);
            if (!(here > 0.0) || bend > std::max(round, surface.row_pitch)) continue;
            const double slope2 = std::pow((right - left) / (2.0 * round), 2) +
                                  std::pow((above - below) / (2.0 * surface.row_pitch), 2);
            const double way2 = round * round + surface.row_pitch * surface.row_pitch;
            asked.push_back(0.25 * bend + way2 * std::pow(1.0 + slope2, 1.5) / (8.0 * tool.radius));
        }
    }
    if (asked.empty()) return 0.0;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(asked.size() - 1));
    std::nth_element(asked.begin(), asked.begin() + place, asked.end());
    return asked[static_cast<std::size_t>(place)];
}

}  // namespace psicarve::tool
