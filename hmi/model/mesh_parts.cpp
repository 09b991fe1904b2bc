// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/mesh_parts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "hmi/model/edge_hash.hpp"

namespace psicarve::model {
namespace {

using Corner = std::array<float, 3>;

struct CornerHash {
    std::size_t operator()(const Corner& corner) const noexcept { return vertex_hash(corner); }
};

/// Sets of numbers that are joined two by two.
class Joined {
public:
    explicit Joined(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }
    std::uint32_t root(std::uint32_t at) {
        while (parent_[at] != at) at = parent_[at] = parent_[parent_[at]];
        return at;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

private:
    std::vector<std::uint32_t> parent_;
};

using Facet = std::array<std::uint32_t, 3>;  // its corners

std::vector<Facet> numbered(const TriangleList& triangles, std::size_t& corner_count) {
    std::unordered_map<Corner, std::uint32_t, CornerHash> numbers;
    numbers.reserve(triangles.size());
    std::vector<Facet> facets;
    facets.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        Facet facet{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto next = static_cast<std::uint32_t>(numbers.size());
            facet[k] = numbers.try_emplace(triangle.vertices[k], next).first->second;
        }
        facets.push_back(facet);
    }
    corner_count = numbers.size();
    return facets;
}

/// Edges with an odd number of facets, as the lower corner and the higher in one number.
std::unordered_set<std::uint64_t> open_edges(const std::vector<Facet>& facets) {
    std::unordered_set<std::uint64_t> odd;
    for (const Facet& facet : facets) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(facet[k], facet[(k + 1) % 3]);
            if (low == high) continue;
            const std::uint64_t edge = (std::uint64_t{low} << 32U) | high;
            if (!odd.insert(edge).second) odd.erase(edge);
        }
    }
    return odd;
}

double volume_of(const Triangle& triangle, const Corner& origin) {
    std::array<std::array<double, 3>, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) v[i][k] = double{triangle.vertices[i][k]} - double{origin[k]};
    }
    return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
           v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
           v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}

}  // namespace

MeshParts parts_of(const TriangleList& triangles) {
    std::size_t corner_count = 0;
    const std::vector<Facet> facets = numbered(triangles, corner_count);
    Joined bodies(corner_count);
    for (const Facet& facet : facets) {
        bodies.join(facet[0], facet[1]);
        bodies.join(facet[1], facet[2]);
    }
    Joined rims(corner_count);
    const auto open = open_edges(facets);
    std::unordered_set<std::uint32_t> open_bodies;
    for (const std::uint64_t edge : open) {
        const auto high = static_cast<std::uint32_t>(edge);
        rims.join(static_cast<std::uint32_t>(edge >> 32U), high);
        open_bodies.insert(bodies.root(high));
    }
    std::unordered_set<std::uint32_t> holes;
    for (const std::uint64_t edge : open) holes.insert(rims.root(static_cast<std::uint32_t>(edge)));
    std::unordered_map<std::uint32_t, double> volumes;
    for (std::size_t i = 0; i < facets.size(); ++i)
        volumes[bodies.root(facets[i][0])] += volume_of(triangles[i], triangles.front().vertices[0]);
    MeshParts parts;
    parts.components = volumes.size();
    parts.open = open_bodies.size();
    parts.holes = holes.size();
    for (const auto& [body, volume] : volumes)
        parts.inside_out += volume < 0.0 && !open_bodies.contains(body) ? 1 : 0;
    return parts;
}

}  // namespace psicarve::model
