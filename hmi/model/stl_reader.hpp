// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {

inline constexpr std::uint64_t kStlHeaderBytes = 84;  ///< 80 of free text, 4 of facet count
inline constexpr std::uint64_t kStlFacetBytes = 50;

/// Whether the size is exactly what the binary header's facet count requires. Requires >= 84 bytes of head.
bool is_exact_binary_stl(std::span<const char> head, std::uint64_t size_bytes) noexcept;

/// Reads facets, hashes the bytes and checks the facets in one pass over the file. A file shorter than
/// 84 + 50 * count is refused as truncated, unless the count is 0 or 0xFFFFFFFF: then the size decides.
/// Anything after the last facet is ignored.
Result<Mesh> read_binary_stl(const InputFile& file);

/// ASCII STL, several solids in a file included. A refusal names the line.
Result<Mesh> read_ascii_stl(const InputFile& file);

}  // namespace psicarve::model
