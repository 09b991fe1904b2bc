// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hmi/piece/piece_deviation.hpp"
#include "shared/base/result.hpp"

namespace psicarve::piece {

/// An 800 pixel wide PNG: the piece unrolled, coloured by its distance from the model, with the colours'
/// scale and the histogram. A pixel shows the largest deviation among its places.
Result<std::vector<std::byte>> deviation_png(const PieceDeviation& deviation, const std::string& model_name);

/// Writes it to a file, atomically.
Result<void> write_deviation_picture(const std::string& path, const PieceDeviation& deviation,
                                     const std::string& model_name);

}  // namespace psicarve::piece
