// SPDX-License-Identifier: GPL-3.0-or-later
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "hmi/model/stl_reader.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

constexpr std::uint64_t kNormalBytes = 12;
constexpr std::size_t kChunkFacets = 4096;  // 200 kB: stays in the cache from reading to checking

std::uint32_t announced_count(std::span<const char> head) noexcept {
    std::array<unsigned char, 4> b{};
    std::memcpy(b.data(), head.data() + 80, b.size());
    return static_cast<std::uint32_t>(b[0]) | (static_cast<std::uint32_t>(b[1]) << 8U) |
           (static_cast<std::uint32_t>(b[2]) << 16U) | (static_cast<std::uint32_t>(b[3]) << 24U);
}

using HashState = std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)>;

/// Hashes the bytes behind the last facet: the hash is of the whole file.
Result<void> hash_rest(const InputFile& file, std::uint64_t offset, std::span<char> buffer,
                       XXH3_state_t* hash) {
    while (offset < file.size_bytes()) {
        const std::size_t part =
            static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), file.size_bytes() - offset));
        if (auto done = file.read(offset, buffer.first(part)); !done) return done.error();
        XXH3_64bits_update(hash, buffer.data(), part);
        offset += part;
    }
    return {};
}

Result<Mesh> read_facets(const InputFile& file, std::uint64_t facet_count) {
    Mesh mesh;
    mesh.format = "binary STL";
    mesh.triangles.resize(facet_count);
    std::vector<char> buffer(kChunkFacets * kStlFacetBytes);
    const HashState hash(XXH3_createState(), &XXH3_freeState);
    XXH3_64bits_reset(hash.get());
    if (auto done = file.read(0, std::span(buffer).first(kStlHeaderBytes)); !done) return done.error();
    XXH3_64bits_update(hash.get(), buffer.data(), kStlHeaderBytes);

    MeshCheck check;
    std::size_t kept = 0;
    for (std::uint64_t first = 0; first < facet_count; first += kChunkFacets) {
        const std::size_t facets =
            static_cast<std::size_t>(std::min<std::uint64_t>(kChunkFacets, facet_count - first));
        const std::span<char> bytes = std::span(buffer).first(facets * kStlFacetBytes);
        if (auto done = file.read(kStlHeaderBytes + first * kStlFacetBytes, bytes); !done)
            return done.error();
        XXH3_64bits_update(hash.get(), bytes.data(), bytes.size());
        for (std::size_t i = 0; i < facets; ++i) {
            const char* coordinates = bytes.data() + i * kStlFacetBytes + kNormalBytes;
            kept += check.accept(coordinates, mesh.triangles[kept]) ? 1 : 0;
        }
    }
    mesh.triangles.resize(kept);
    const std::uint64_t end = kStlHeaderBytes + facet_count * kStlFacetBytes;
    if (auto done = hash_rest(file, end, buffer, hash.get()); !done) return done.error();
    mesh.source_hash = XXH3_64bits_digest(hash.get());
    mesh.facts = check.facts(mesh.origin);
    mesh.facts.coordinate_step = float_step_at(mesh.facts);
    return mesh;
}

}  // namespace

bool is_exact_binary_stl(std::span<const char> head, std::uint64_t size_bytes) noexcept {
    const std::uint64_t count = announced_count(head);
    return count > 0 && size_bytes == kStlHeaderBytes + count * kStlFacetBytes;
}

Result<Mesh> read_binary_stl(const InputFile& file) {
    std::array<char, kStlHeaderBytes> head{};
    if (file.size_bytes() < kStlHeaderBytes) {
        return bad_input(file.path() + ": truncated: a binary STL begins with 84 bytes, the file has " +
                         std::to_string(file.size_bytes()));
    }
    if (auto done = file.read(0, head); !done) return done.error();
    const std::uint64_t announced = announced_count(head);
    const std::uint64_t present = (file.size_bytes() - kStlHeaderBytes) / kStlFacetBytes;
    const bool size_decides = announced == 0 || announced == 0xFFFFFFFFU;
    if (!size_decides && announced > present) {
        return bad_input(file.path() + ": truncated, or not an STL file: the header announces " +
                         std::to_string(announced) + " facets, the file has room for " +
                         std::to_string(present));
    }
    try {
        return read_facets(file, size_decides ? present : announced);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, file.path() + ": too large for this computer's memory"};
    }
}

}  // namespace psicarve::model
