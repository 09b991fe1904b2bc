// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/exif.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace psicarve::flat {
namespace {

constexpr std::string_view kExif{"Exif\0\0", 6};
constexpr std::uint32_t kOrientationTag = 0x0112;
constexpr std::uint32_t kShortType = 3;
constexpr std::size_t kEntryBytes = 12;

/// Numbers of a TIFF's head; 0 beyond its end.
class TiffNumbers {
public:
    explicit TiffNumbers(Bytes bytes) : bytes_(bytes), is_big_(!bytes.empty() && bytes[0] == 'M') {}

    std::uint32_t at(std::size_t place, std::size_t count) const noexcept {
        if (place > bytes_.size() || bytes_.size() - place < count) return 0;
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < count; ++i)
            value = value << 8U | bytes_[place + (is_big_ ? i : count - 1 - i)];
        return value;
    }

private:
    Bytes bytes_;
    bool is_big_;
};

}  // namespace

// Source: Exif 2.3, 4.6: a TIFF header, whose first directory has the orientation as a short.
int exif_orientation(Bytes marker) noexcept {
    const auto same = [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; };
    if (marker.size() < kExif.size() || !std::equal(kExif.begin(), kExif.end(), marker.begin(), same))
        return 1;
    const TiffNumbers tiff(marker.subspan(kExif.size()));
    if (tiff.at(2, 2) != 42) return 1;
    const std::size_t directory = tiff.at(4, 4);
    const std::size_t entries = tiff.at(directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * kEntryBytes;
        if (tiff.at(entry, 2) != kOrientationTag || tiff.at(entry + 2, 2) != kShortType) continue;
        const std::uint32_t value = tiff.at(entry + 8, 2);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

void turn_upright(GreyImage& image, int orientation) {
    if (orientation <= 1 || orientation > 8) return;
    // 5 to 8: rows are columns. Then from which sides rows and columns are counted.
    const bool is_on_its_side = orientation >= 5;
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    const std::size_t width = is_on_its_side ? image.height : image.width;
    const std::size_t height = is_on_its_side ? image.width : image.height;
    std::vector<std::uint16_t> upright(image.values.size());
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            // Of the stored picture; sides are those of the stored one as well.
            const std::size_t column = is_on_its_side ? y : x;
            const std::size_t row = is_on_its_side ? x : y;
            const std::size_t from_x = from_right ? image.width - 1 - column : column;
            const std::size_t from_y = from_bottom ? image.height - 1 - row : row;
            upright[y * width + x] = image.values[from_y * image.width + from_x];
        }
    }
    image.values = std::move(upright);
    image.width = width;
    image.height = height;
}

}  // namespace psicarve::flat
