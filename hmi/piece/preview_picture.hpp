// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hmi/piece/stock_map.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// The text of a preview, beside the piece.
struct PreviewText {
    std::string title;
    std::vector<std::string> lines;  ///< a name of up to 11 characters, padded with blanks, and its value
    std::vector<std::string> warnings;
};

/// An 800 pixel wide PNG: some rows of a piece from two sides within the outline of the blank, if its size is
/// known, lines of text beside it, and the warnings below, wrapped.
Result<std::vector<std::byte>> preview_png(const StockMap& piece, std::span<const std::size_t> rows,
                                           const BlankProfile& blank, const PreviewText& text);

}  // namespace psicarve::piece
