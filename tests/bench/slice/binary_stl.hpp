// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "hmi/model/mesh.hpp"

namespace psicarve::bench {

constexpr std::size_t kHeadBytes = 80;
constexpr std::size_t kFacetBytes = 50;
constexpr std::size_t kNormalBytes = 12;

/// Whether the file was written.
inline bool write_binary_stl(const model::TriangleList& triangles, const std::string& file) {
    std::ofstream out(file, std::ios::binary);
    const std::array<char, kHeadBytes> head{};
    out.write(head.data(), head.size());
    const auto count = static_cast<std::uint32_t>(triangles.size());
    out.write(reinterpret_cast<const char*>(&count), sizeof(count));
    std::array<char, kFacetBytes> facet{};
    for (const model::Triangle& triangle : triangles) {
        std::memcpy(facet.data() + kNormalBytes, &triangle, sizeof(triangle));
        out.write(facet.data(), facet.size());
    }
    return out.good();
}

/// The facets as plainly as they can be read: all at once, and nothing is looked at.
inline std::vector<model::Triangle> read_binary_stl_plainly(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::array<char, kHeadBytes> head{};
    std::uint32_t count = 0;
    in.read(head.data(), head.size());
    in.read(reinterpret_cast<char*>(&count), sizeof(count));
    std::vector<char> bytes(std::size_t{count} * kFacetBytes);
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    std::vector<model::Triangle> triangles(in.good() ? count : 0);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        std::memcpy(&triangles[i], bytes.data() + i * kFacetBytes + kNormalBytes, sizeof(model::Triangle));
    return triangles;
}

}  // namespace psicarve::bench
