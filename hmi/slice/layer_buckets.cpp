// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/layer_buckets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hmi/model/large_memory.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/layer_finder.hpp"
#include "hmi/slice/placement.hpp"

namespace psicarve::slice {
LayerBuckets::LayerBuckets(const model::TriangleList& triangles, Up up, std::span<const double> bottoms,
                           std::span<const double> tops)
    : starts_(tops.size() + 1, 0), cut_counts_(tops.size(), 0) {
    if (tops.empty()) return;
    const LayerFinder bottom_finder(bottoms);
    const LayerFinder top_finder(tops);
    const std::array<std::size_t, 3> from = source_coordinate(up);
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    struct Range {
        std::uint32_t first;
        std::uint32_t end;
    };
    std::vector<Range, model::UnsetAllocator<Range>> ranges(triangles.size());
    std::vector<std::int64_t> change(tops.size() + 1, 0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& v = triangles[i].vertices;
        const float z0 = v[0][from[2]];
        const float z1 = v[1][from[2]];
        const float z2 = v[2][from[2]];
        const float low = std::min(std::min(z0, z1), z2);
        const float high = std::max(std::max(z0, z1), z2);
        const Range range{top_finder.first_at_or_above(low), bottom_finder.first_at_or_above(high)};
        ranges[i] = range.first < range.end ? range : Range{kNone, kNone};
        if (range.first >= range.end) continue;
        ++starts_[range.first + 1];
        ++change[range.first];
        --change[range.end];
    }
    std::int64_t cut = 0;
    for (std::size_t layer = 0; layer < tops.size(); ++layer) {
        starts_[layer + 1] += starts_[layer];
        cut += change[layer];
        cut_counts_[layer] = static_cast<std::uint32_t>(cut);
    }
    facets_.resize(starts_.back());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (ranges[i].first == kNone) continue;
        facets_[next[ranges[i].first]++] = {static_cast<std::uint32_t>(i), ranges[i].end};
    }
}

}  // namespace psicarve::slice
