// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hmi/flat/grey_image.hpp"
#include "hmi/flat/relief.hpp"
#include "tests/fuzz/require.hpp"

namespace {

using namespace psicarve;
using fuzz::require;
using fuzz::require_one_line;

constexpr std::size_t kPngHeadBytes = 8;
constexpr std::size_t kChunkFrameBytes = 12;  // length, name and sum
constexpr std::size_t kMostDepths = 100'000;  // large pictures are read, and left at that

/// A PNG whose chunks have the sums that they should have: else hardly one mutation gets past these.
std::vector<unsigned char> with_right_sums(flat::Bytes bytes) {
    std::vector<unsigned char> out(bytes.begin(), bytes.end());
    for (std::size_t at = kPngHeadBytes; at + kChunkFrameBytes <= out.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8U | out[at + i];
        if (length > out.size() - at - kChunkFrameBytes) break;
        const auto sum = crc32(0, &out[at + 4], static_cast<uInt>(length + 4));
        for (std::size_t i = 0; i < 4; ++i)
            out[at + 8 + length + i] = static_cast<unsigned char>(sum >> (24U - 8U * i));
        at += kChunkFrameBytes + length;
    }
    return out;
}

/// No place of the relief is deeper than black or less deep than white.
void require_depths(const flat::GreyImage& image, const flat::FlatOptions& options) {
    const auto map = flat::depths_of(image, options, "fuzzed");
    require_one_line(map);
    if (!map) return;
    require(map->depth_mm.size() == map->width * map->height, "every place has its depth");
    constexpr float kRounding_mm = 1e-5F;
    for (const float depth_mm : map->depth_mm) {
        require(depth_mm >= static_cast<float>(options.white_depth_mm) - kRounding_mm &&
                    depth_mm <= static_cast<float>(options.depth_mm) + kRounding_mm,
                "a depth lies between white's and black's");
    }
}

}  // namespace

/// A picture is refused with one line, or it has as many pixels as it says, and depths.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<unsigned char> bytes(data, data + size);
    if (flat::image_format(bytes) == flat::ImageFormat::png) bytes = with_right_sums(bytes);
    const auto image = flat::read_image(bytes, "fuzzed");
    require_one_line(image);
    if (!image) return 0;
    require(image->width > 0 && image->height > 0, "a picture has pixels");
    require(image->values.size() == image->width * image->height, "all pixels are there");
    if (image->values.size() > kMostDepths) return 0;
    flat::FlatOptions options;
    require_depths(*image, options);
    options.is_inverted = true;
    options.white_depth_mm = 0.5;
    options.gamma = 0.4;
    options.smooth_mm = 1.5;
    options.blends_seam = true;
    options.height_mm = 10.0;
    require_depths(*image, options);
    return 0;
}
