// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "hmi/model/mesh.hpp"

namespace psicarve::model {

/// Hashes that do not depend on the order in which a mesh lists its facets. Vertices are the same when their
/// coordinates are, bit for bit (-0 counts as 0 only after MeshCheck::accept).
constexpr std::uint64_t vertex_hash(const std::array<float, 3>& v) noexcept {
    const std::uint64_t x = std::bit_cast<std::uint32_t>(v[0]);
    const std::uint64_t y = std::bit_cast<std::uint32_t>(v[1]);
    const std::uint64_t z = std::bit_cast<std::uint32_t>(v[2]);
    std::uint64_t h = (x | (y << 32U)) * 0x9e3779b97f4a7c15ULL + (z + 1) * 0xd1b54a32d192ed03ULL;
    h ^= h >> 31U;
    h *= 0xbf58476d1ce4e5b9ULL;
    return h ^ (h >> 29U);
}

/// The same for both directions of an edge.
constexpr std::uint64_t edge_hash(std::uint64_t from, std::uint64_t to) noexcept {
    std::uint64_t h = (from + to) * 0x94d049bb133111ebULL;
    h ^= h >> 32U;
    return h * 0x2545f4914f6cdd1dULL;
}

/// Changes its sign with the direction of the edge.
constexpr std::uint64_t directed_edge_hash(std::uint64_t from, std::uint64_t to,
                                           std::uint64_t edge) noexcept {
    return (from - to) * (edge | 1U);
}

}  // namespace psicarve::model
