// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::flat {

/// A picture's brightness, row by row from the top: 0 black, 65535 white. Eight bits are spread over sixteen.
struct GreyImage {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint16_t> values;
    std::string format;                 ///< "PNG, 16 bits", "JPEG", ...
    std::vector<std::string> warnings;  ///< colour was made grey, transparency white
};

// The size limit of a picture: 200 MB in memory.
inline constexpr std::uint64_t kMostPixels = 100'000'000;
inline constexpr std::uint32_t kMostSide = 65'535;

/// Refuses impossible sizes, and those above the limit.
Result<void> check_image_size(std::uint64_t width, std::uint64_t height, const std::string& file);

/// Brightness of a colour by the television standard (BT.601), whatever its gamma: the grey that drawing
/// programs show.
constexpr std::uint16_t grey_of(std::uint32_t red, std::uint32_t green, std::uint32_t blue) noexcept {
    return static_cast<std::uint16_t>((299U * red + 587U * green + 114U * blue + 500U) / 1000U);
}
/// Blends a pixel over white paper.
constexpr std::uint16_t over_white(std::uint32_t grey, std::uint32_t alpha) noexcept {
    return static_cast<std::uint16_t>((grey * alpha + 65535U * (65535U - alpha) + 32767U) / 65535U);
}

using Bytes = std::span<const unsigned char>;

/// Each refuses what is damaged or cut short with one line: "FILE: ...".
Result<GreyImage> read_png(Bytes bytes, const std::string& file);
Result<GreyImage> read_jpeg(Bytes bytes, const std::string& file);
Result<GreyImage> read_tiff(Bytes bytes, const std::string& file);
Result<GreyImage> read_bmp(Bytes bytes, const std::string& file);
/// Portable grey, bit and pix maps, as text or binary (P1 to P6).
Result<GreyImage> read_pnm(Bytes bytes, const std::string& file);

enum class ImageFormat : std::uint8_t { none, png, jpeg, tiff, bmp, pnm };
/// By the first bytes alone.
ImageFormat image_format(Bytes head) noexcept;
Result<GreyImage> read_image(Bytes bytes, const std::string& file);

}  // namespace psicarve::flat
