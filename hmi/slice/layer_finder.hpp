// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace psicarve::slice {

/// Finds layers by height: guesses as if they were evenly spaced, then corrects.
class LayerFinder {
public:
    /// Requires ascending heights, one at least, that outlive the finder.
    explicit LayerFinder(std::span<const double> heights) : heights_(heights) {
        const double range = heights.back() - heights.front();
        if (heights.size() > 1 && range > 0.0) {
            layers_per_unit_ = static_cast<double>(heights.size() - 1) / range;
        }
    }

    /// The first layer at or above z; the layer count when there is none.
    std::uint32_t first_at_or_above(double z) const noexcept {
        if (z <= heights_.front()) return 0;
        if (z > heights_.back()) return static_cast<std::uint32_t>(heights_.size());
        auto i = static_cast<std::size_t>((z - heights_.front()) * layers_per_unit_) + 1;
        i = std::min(i, heights_.size() - 1);
        while (i > 0 && heights_[i - 1] >= z) --i;
        while (heights_[i] < z) ++i;
        return static_cast<std::uint32_t>(i);
    }

private:
    std::span<const double> heights_;
    double layers_per_unit_ = 0.0;
};

}  // namespace psicarve::slice
