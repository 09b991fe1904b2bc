// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "hmi/flat/grey_image.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

// Source: Microsoft's description of BITMAPFILEHEADER and BITMAPINFOHEADER; all numbers little-endian.
constexpr std::size_t kFileHeaderBytes = 14;
constexpr std::size_t kLeastInfoBytes = 40;
constexpr std::size_t kMasksBytes = 12;
constexpr std::uint32_t kUncompressed = 0;
constexpr std::uint32_t kWithMasks = 3;

std::uint32_t word(Bytes bytes, std::size_t at, std::size_t count) noexcept {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value |= std::uint32_t{bytes[at + i]} << (8U * i);
    return value;
}

/// The places of a pixel's blue, green and red bytes.
struct ColourBytes {
    std::size_t blue = 0;
    std::size_t green = 1;
    std::size_t red = 2;
};

/// By the three masks behind the head; nothing where these are not a byte each, of its own.
std::optional<ColourBytes> colour_bytes(Bytes bytes) noexcept {
    std::array<std::size_t, 3> places{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::uint32_t mask = word(bytes, kFileHeaderBytes + kLeastInfoBytes + 4 * i, 4);
        while (places[i] < 4 && mask != 0xFFU << (8U * places[i])) ++places[i];
        if (places[i] == 4) return std::nullopt;
    }
    if (places[0] == places[1] || places[1] == places[2] || places[0] == places[2]) return std::nullopt;
    return ColourBytes{.blue = places[2], .green = places[1], .red = places[0]};
}

std::uint16_t grey8(std::uint32_t red, std::uint32_t green, std::uint32_t blue) noexcept {
    return grey_of(red * 257U, green * 257U, blue * 257U);
}

}  // namespace

Result<GreyImage> read_bmp(Bytes bytes, const std::string& file) {
    const Error cut = bad_input(file + ": a damaged BMP picture: the file ends too early");
    if (bytes.size() < kFileHeaderBytes + kLeastInfoBytes) return cut;
    const std::uint64_t pixels_at = word(bytes, 10, 4);
    const std::uint64_t info_bytes = word(bytes, 14, 4);
    const auto width = static_cast<std::int32_t>(word(bytes, 18, 4));
    const auto signed_height = static_cast<std::int32_t>(word(bytes, 22, 4));
    const std::uint32_t bits = word(bytes, 28, 2);
    const std::uint32_t packing = word(bytes, 30, 4);
    if (info_bytes < kLeastInfoBytes)
        return bad_input(file + ": a BMP picture of OS/2's kind, which is not read");
    const bool is_known = bits == 1 || bits == 4 || bits == 8 || bits == 24 || bits == 32;
    const bool has_masks = packing == kWithMasks && bits == 32;
    if (has_masks && bytes.size() < kFileHeaderBytes + kLeastInfoBytes + kMasksBytes) return cut;
    const auto colours = has_masks ? colour_bytes(bytes) : ColourBytes{};
    if (!is_known || (packing != kUncompressed && !has_masks) || !colours) {
        return bad_input(file + ": a BMP picture of a kind that is not read (" + std::to_string(bits) +
                         " bits, compression " + std::to_string(packing) + "); save it as PNG");
    }
    const auto height = static_cast<std::uint64_t>(std::abs(std::int64_t{signed_height}));
    if (width < 0) return bad_input(file + ": a picture without pixels");
    const auto columns = static_cast<std::uint64_t>(width);
    if (auto fits = check_image_size(columns, height, file); !fits) return fits.error();
    const std::uint64_t row_bytes = (columns * bits + 31) / 32 * 4;
    const std::uint64_t head_bytes = kFileHeaderBytes + info_bytes;
    if (pixels_at < head_bytes && head_bytes <= bytes.size()) {
        return bad_input(file + ": a damaged BMP picture: its pixels are said to begin at byte " +
                         std::to_string(pixels_at) + ", inside its head of " + std::to_string(head_bytes));
    }
    if (pixels_at < head_bytes || pixels_at > bytes.size() || bytes.size() - pixels_at < row_bytes * height)
        return cut;

    std::array<std::uint16_t, 256> palette{};
    bool was_colour = bits > 8;
    if (bits <= 8) {
        const std::uint32_t used = word(bytes, 46, 4);
        const std::size_t count =
            used == 0 ? std::size_t{1} << bits : std::min<std::size_t>(used, 1U << bits);
        if (bytes.size() - head_bytes < 4 * count) return cut;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t entry = static_cast<std::size_t>(head_bytes) + 4 * i;
            const std::uint32_t b = bytes[entry], g = bytes[entry + 1], r = bytes[entry + 2];
            palette[i] = grey8(r, g, b);
            was_colour = was_colour || r != g || g != b;
        }
    }
    GreyImage image{static_cast<std::size_t>(columns), static_cast<std::size_t>(height), {}, "BMP", {}};
    image.values.reserve(image.width * image.height);
    for (std::uint64_t y = 0; y < height; ++y) {
        // Rows stand from the bottom up, unless the height is negative.
        const std::uint64_t row = pixels_at + row_bytes * (signed_height > 0 ? height - 1 - y : y);
        for (std::uint64_t x = 0; x < columns; ++x) {
            const auto at = static_cast<std::size_t>(row + x * bits / 8);
            if (bits > 8) {
                image.values.push_back(
                    grey8(bytes[at + colours->red], bytes[at + colours->green], bytes[at + colours->blue]));
                continue;
            }
            const auto shift = static_cast<unsigned>(8 - bits - (x * bits) % 8);
            image.values.push_back(palette[(bytes[at] >> shift) & ((1U << bits) - 1U)]);
        }
    }
    if (was_colour) image.warnings.emplace_back("the picture is in colour; its brightness is taken");
    return image;
}

}  // namespace psicarve::flat
