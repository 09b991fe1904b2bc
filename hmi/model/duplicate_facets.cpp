// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/duplicate_facets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "hmi/model/edge_hash.hpp"
#include "hmi/model/hash_sort.hpp"
#include "hmi/model/mesh.hpp"

namespace psicarve::model {
namespace {

// Of ten facets of a model with two sides nine at least have their other side in the file.
constexpr std::uint64_t kTwoSidedTenths = 9;

enum class Likeness : std::uint8_t { other, same, turned };

Likeness compare(const Triangle& a, const Triangle& b) noexcept {
    const auto& v = a.vertices;
    const auto& w = b.vertices;
    for (std::size_t i = 0; i < 3; ++i) {
        if (v[0] != w[i]) continue;
        if (v[1] == w[(i + 1) % 3] && v[2] == w[(i + 2) % 3]) return Likeness::same;
        if (v[1] == w[(i + 2) % 3] && v[2] == w[(i + 1) % 3]) return Likeness::turned;
    }
    return Likeness::other;
}

using Hashed = std::pair<std::uint64_t, std::uint32_t>;  ///< of a facet, and its place in the list

std::vector<Hashed> sorted_hashes(const TriangleList& triangles) {
    std::vector<Hashed> hashes;
    hashes.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        hashes.emplace_back(
            vertex_hash(t.vertices[0]) + vertex_hash(t.vertices[1]) + vertex_hash(t.vertices[2]),
            static_cast<std::uint32_t>(hashes.size()));
    }
    sort_by_hash(hashes, [](const Hashed& facet) { return facet.first; });
    return hashes;
}

/// What each facet is to those of its hash that stand before it.
std::vector<Likeness> likenesses(const TriangleList& triangles) {
    const std::vector<Hashed> hashes = sorted_hashes(triangles);
    std::vector<Likeness> out(triangles.size(), Likeness::other);
    for (std::size_t first = 0; first < hashes.size();) {
        std::size_t end = first + 1;
        for (; end < hashes.size() && hashes[end].first == hashes[first].first; ++end) {
            Likeness& likeness = out[hashes[end].second];
            for (std::size_t k = first; k < end && likeness != Likeness::same; ++k) {
                if (out[hashes[k].second] == Likeness::same) continue;
                const Likeness found = compare(triangles[hashes[k].second], triangles[hashes[end].second]);
                if (found != Likeness::other) likeness = found;
            }
        }
        first = end;
    }
    return out;
}

}  // namespace

std::uint64_t drop_duplicates(TriangleList& triangles) {
    const std::vector<Likeness> likeness = likenesses(triangles);
    const auto count = [&likeness](Likeness wanted) {
        return static_cast<std::uint64_t>(std::count(likeness.begin(), likeness.end(), wanted));
    };
    const std::uint64_t same = count(Likeness::same);
    const std::uint64_t turned = count(Likeness::turned);
    const bool is_two_sided = turned * 2 * 10 >= (triangles.size() - same) * kTwoSidedTenths;
    if (same == 0 && !(is_two_sided && turned > 0)) return 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const bool is_dropped =
            likeness[i] == Likeness::same || (is_two_sided && likeness[i] == Likeness::turned);
        if (!is_dropped) triangles[kept++] = triangles[i];
    }
    const std::uint64_t dropped = triangles.size() - kept;
    triangles.resize(kept);
    return dropped;
}

}  // namespace psicarve::model
