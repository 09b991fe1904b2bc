// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/grey_image.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "hmi/model/foreign_file.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

Result<void> check_image_size(std::uint64_t width, std::uint64_t height, const std::string& file) {
    if (width == 0 || height == 0) return bad_input(file + ": a picture without pixels");
    if (width <= kMostSide && height <= kMostSide && width * height <= kMostPixels) return {};
    return bad_input(file + ": a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels; at most 100 million can be read, and 65535 a side");
}

ImageFormat image_format(Bytes head) noexcept {
    const auto begins = [head](std::string_view magic) {
        return head.size() >= magic.size() &&
               std::equal(magic.begin(), magic.end(), head.begin(),
                          [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; });
    };
    using namespace std::string_view_literals;
    if (begins("\x89PNG\r\n\x1A\n"sv)) return ImageFormat::png;
    if (begins("\xFF\xD8\xFF"sv)) return ImageFormat::jpeg;
    if (begins("II*\0"sv) || begins("MM\0*"sv) || begins("II+\0"sv) || begins("MM\0+"sv))
        return ImageFormat::tiff;
    if (begins("BM"sv) && head.size() >= 26 && head[6] == 0 && head[7] == 0) return ImageFormat::bmp;
    const bool is_map = head.size() > 2 && head[0] == 'P' && head[1] >= '1' && head[1] <= '6';
    if (is_map &&
        (head[2] == ' ' || head[2] == '\n' || head[2] == '\r' || head[2] == '\t' || head[2] == '#')) {
        return ImageFormat::pnm;
    }
    return ImageFormat::none;
}

Result<GreyImage> read_image(Bytes bytes, const std::string& file) {
    switch (image_format(bytes)) {
        case ImageFormat::png:
            return read_png(bytes, file);
        case ImageFormat::jpeg:
            return read_jpeg(bytes, file);
        case ImageFormat::tiff:
            return read_tiff(bytes, file);
        case ImageFormat::bmp:
            return read_bmp(bytes, file);
        case ImageFormat::pnm:
            return read_pnm(bytes, file);
        case ImageFormat::none:
            break;
    }
    const std::string_view head(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (const auto foreign = model::foreign_kind(head); !foreign.empty())
        return bad_input(file + ": " + std::string(foreign));
    return bad_input(file + ": not a picture that can be read here (PNG, JPEG, TIFF, BMP, PGM)");
}

}  // namespace psicarve::flat
