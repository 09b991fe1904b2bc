// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/edge_count.hpp"

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

using Vertex = std::array<float, 3>;

/// Hash of an edge, whose lowest bit holds the direction; 0 for an edge without length.
std::uint64_t key_of(std::uint64_t from, std::uint64_t to) noexcept {
    if (from == to) return 0;
    return (edge_hash(from, to) & ~1ULL) | (from < to ? 1U : 0U);
}

/// Sorts the keys and counts; the undirected hashes of the edges that are not in order go to `bad`, sorted.
EdgeCounts count_keys(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& bad) {
    sort_by_hash(keys, [](std::uint64_t key) { return key; });
    EdgeCounts counts;
    for (std::size_t i = 0; i < keys.size();) {
        std::size_t end = i;
        std::int64_t balance = 0;
        for (; end < keys.size() && (keys[end] | 1U) == (keys[i] | 1U); ++end) {
            balance += (keys[end] & 1U) != 0 ? 1 : -1;
        }
        const bool is_open = (end - i) % 2 != 0;
        if (is_open) ++counts.open;
        if (!is_open && balance != 0) ++counts.turned;
        if (is_open || balance != 0) bad.push_back(keys[i] & ~1ULL);
        i = end;
    }
    return counts;
}

std::array<std::uint64_t, 3> keys_of(const Triangle& t) noexcept {
    const std::array<std::uint64_t, 3> h{vertex_hash(t.vertices[0]), vertex_hash(t.vertices[1]),
                                         vertex_hash(t.vertices[2])};
    return {key_of(h[0], h[1]), key_of(h[1], h[2]), key_of(h[2], h[0])};
}

using Edge = std::pair<Vertex, Vertex>;

/// The edges with these hashes, each as often as facets have it.
std::vector<Edge> edges_of(const TriangleList& triangles, const std::vector<std::uint64_t>& bad) {
    std::vector<Edge> edges;
    const HashSieve sieve(bad);
    for (const Triangle& t : triangles) {
        const auto keys = keys_of(t);
        for (std::size_t i = 0; i < 3; ++i) {
            if (keys[i] == 0 || !sieve.may_hold(keys[i] & ~1ULL)) continue;
            if (!std::binary_search(bad.begin(), bad.end(), keys[i] & ~1ULL)) continue;
            edges.emplace_back(t.vertices[i], t.vertices[(i + 1) % 3]);
        }
    }
    return edges;
}

/// Makes coordinates that lie within the tolerance of each other equal, on each axis apart.
void weld(std::vector<Edge>& edges, double tolerance) {
    std::vector<float*> coordinates;
    coordinates.reserve(edges.size() * 2);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        coordinates.clear();
        for (Edge& edge : edges) {
            coordinates.push_back(&edge.first[axis]);
            coordinates.push_back(&edge.second[axis]);
        }
        std::sort(coordinates.begin(), coordinates.end(),
                  [](const float* a, const float* b) { return *a < *b; });
        float first = *coordinates.front();
        for (float* coordinate : coordinates) {
            if (double{*coordinate} - double{first} > tolerance) first = *coordinate;
            *coordinate = first;
        }
    }
}

/// For the hash of a vertex: the vertex whose place it takes.
using Moves = std::vector<std::pair<std::uint64_t, Vertex>>;

/// Moves all but the first of the vertices that welding joins.
Moves moves_of(const std::vector<Edge>& edges, const std::vector<Edge>& welded) {
    std::vector<std::pair<Vertex, Vertex>> places;  // welded, as it stands
    for (std::size_t i = 0; i < edges.size(); ++i) {
        places.emplace_back(welded[i].first, edges[i].first);
        places.emplace_back(welded[i].second, edges[i].second);
    }
    std::sort(places.begin(), places.end());
    Moves moves;
    Vertex first{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i == 0 || places[i].first != places[i - 1].first) first = places[i].second;
        if (places[i].second != first) moves.emplace_back(vertex_hash(places[i].second), first);
    }
    std::sort(moves.begin(), moves.end());
    return moves;
}

void move_vertices(TriangleList& triangles, const Moves& moves) {
    std::vector<std::uint64_t> moved;
    for (const auto& move : moves) moved.push_back(move.first);
    const HashSieve sieve(moved);
    for (Triangle& t : triangles) {
        for (Vertex& v : t.vertices) {
            const std::uint64_t hash = vertex_hash(v);
            if (!sieve.may_hold(hash)) continue;
            const auto move = std::lower_bound(moves.begin(), moves.end(), hash,
                                               [](const auto& m, std::uint64_t h) { return m.first < h; });
            if (move != moves.end() && move->first == hash) v = move->second;
        }
    }
}

EdgeCounts count_all(const TriangleList& triangles, std::vector<std::uint64_t>& bad) {
    std::vector<std::uint64_t> keys;
    keys.reserve(triangles.size() * 3);
    for (const Triangle& t : triangles) {
        for (const std::uint64_t key : keys_of(t)) {
            if (key != 0) keys.push_back(key);
        }
    }
    return count_keys(keys, bad);
}

}  // namespace

EdgeCounts count_edges(const TriangleList& triangles) {
    std::vector<std::uint64_t> bad;
    return count_all(triangles, bad);
}

EdgeCounts join_torn_edges(TriangleList& triangles, double tolerance) {
    std::vector<std::uint64_t> bad;
    const EdgeCounts counts = count_all(triangles, bad);
    if (bad.empty() || !(tolerance > 0.0)) return counts;
    // Rounding can be the reason only where there is a fault, and few vertices are welded more safely than
    // many.
    const std::vector<Edge> edges = edges_of(triangles, bad);
    std::vector<Edge> welded = edges;
    weld(welded, tolerance);
    const Moves moves = moves_of(edges, welded);
    if (!moves.empty()) move_vertices(triangles, moves);
    return moves.empty() ? counts : count_edges(triangles);
}

}  // namespace psicarve::model
