// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hmi/piece/stock_map.hpp"
#include "shared/base/result.hpp"

namespace psicarve::piece {

enum class MeshFormat { stl, ply };

/// The piece as a closed mesh in mm, the axis along z: walls between neighbouring cells, a fan at the bottom
/// and the top. Binary, little endian.
std::vector<std::byte> mesh_bytes(const StockMap& stock, MeshFormat format);

/// Writes by the file's extension: .stl or .ply; any other is bad input. Atomically.
Result<void> write_piece(const std::string& path, const StockMap& stock);
/// Checks the extension before the work.
Result<MeshFormat> mesh_format_of(const std::string& path);

}  // namespace psicarve::piece
