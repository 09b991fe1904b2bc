// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/preview_picture.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace psicarve::piece {
namespace {

constexpr std::size_t kSheetHeight = 540;

struct Decoded {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<png_byte> rgb;

    /// Whether a pixel there has the outline's blue: neither paper, wood, text nor shade.
    bool is_blue(std::size_t x, std::size_t y) const {
        const png_byte* pixel = rgb.data() + 3 * (y * width + x);
        return int{pixel[2]} - int{pixel[0]} > 40;
    }
    /// The first and the last column of a view that the outline touches; {0, 0}: none.
    std::pair<std::size_t, std::size_t> blue_columns(std::size_t from, std::size_t to) const {
        std::pair<std::size_t, std::size_t> found{0, 0};
        for (std::size_t x = from; x < to; ++x) {
            for (std::size_t y = 62; y < 492; ++y) {
                if (!is_blue(x, y)) continue;
                if (found.first == 0) found.first = x;
                found.second = x;
            }
        }
        return found;
    }
};

Decoded preview(const BlankProfile& blank, const std::vector<std::string>& warnings,
                const std::vector<std::string>& lines = {"job        4 layers"}) {
    // A cylinder of 5 mm radius and 10 mm height.
    StockMap piece(5.0, 0.0, 0.25, 40, 90);
    std::vector<std::size_t> rows(piece.row_count());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    const auto bytes = preview_png(piece, rows, blank, {"cylinder", lines, warnings});
    EXPECT_TRUE(bytes.has_value());
    Decoded decoded;
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, bytes->data(), bytes->size()), 0) << image.message;
    image.format = PNG_FORMAT_RGB;
    decoded.rgb.resize(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, decoded.rgb.data(), 0, nullptr), 0) << image.message;
    decoded.width = image.width;
    decoded.height = image.height;
    return decoded;
}

TEST(PreviewPicture, HasTheOutlineOfABlankThatIsKnown) {
    EXPECT_EQ(preview({}, {}).blue_columns(20, 482).first, 0U);
    const Decoded sut = preview({8.0, 12.0, 0.0, 0.0}, {});
    // As wide as the view lets it be, its middle in the view's.
    for (const std::size_t left : {20U, 256U}) {
        const auto [first, last] = sut.blue_columns(left, left + 226);
        EXPECT_NEAR(static_cast<double>(first + last) / 2.0, static_cast<double>(left) + 113.0, 1.5);
        EXPECT_NEAR(static_cast<double>(last - first), 0.94 * 226.0, 3.0);
    }
}

TEST(PreviewPicture, ShowsABlankWhereItStands) {
    // The first view is seen from direction 30: what stands towards 120 is right of its middle there, and
    // left in the other.
    const double turned_rad = 2.0 * M_PI / 3.0;
    const Decoded sut = preview({8.0, 12.0, 3.0 * std::cos(turned_rad), 3.0 * std::sin(turned_rad)}, {});
    const auto middle = [&sut](std::size_t left) {
        const auto [first, last] = sut.blue_columns(left, left + 226);
        return static_cast<double>(first + last) / 2.0 - static_cast<double>(left);
    };
    const double px_per_mm = 0.5 * 0.94 * 226.0 / 11.0;
    EXPECT_NEAR(middle(20), 113.0 + 3.0 * px_per_mm, 2.0);
    EXPECT_NEAR(middle(256), 113.0 - 3.0 * px_per_mm, 2.0);
}

TEST(PreviewPicture, HasItsWarningsInLinesBelow) {
    EXPECT_EQ(preview({}, {}).height, kSheetHeight);
    const std::size_t one = preview({}, {"short"}).height;
    EXPECT_GT(one, kSheetHeight + 10);
    const std::size_t two = preview({}, {"short", "short"}).height;
    EXPECT_EQ(two - one, one - kSheetHeight);
    std::string sentence;
    for (int i = 0; i < 40; ++i) sentence += "a warning ";
    const Decoded sut = preview({}, {sentence});
    EXPECT_GT(sut.height, two) << "broken into lines";
    // Something is written in each of them.
    std::size_t inked = 0;
    for (std::size_t y = kSheetHeight; y < sut.height; ++y) {
        for (std::size_t x = 36; x < 780; ++x) {
            if (sut.rgb[3 * (y * sut.width + x)] > 120) continue;
            ++inked;
            break;
        }
    }
    EXPECT_GT(inked, (sut.height - kSheetHeight) / 2);
    // Below whatever stands beside the piece.
    const std::vector<std::string> many(40, "job        4 layers");
    EXPECT_GT(preview({}, {}, many).height, 60U + 40U * 36U);
    EXPECT_GT(preview({}, {"short"}, many).height, preview({}, {}, many).height + 10);
}

}  // namespace
}  // namespace psicarve::piece
