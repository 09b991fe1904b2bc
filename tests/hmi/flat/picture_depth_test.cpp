// SPDX-License-Identifier: GPL-3.0-or-later
// Known pixels of every format, to the depths and radii that they ask for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/hmi/flat/picture_files.hpp"

namespace psicarve::flat {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr double kFloat_mm = 2e-6;  // depths are held in single precision

/// The bytes of a BMP of 40 bytes of head, whose rows are given as they stand in it, the lowest first.
std::string bmp(std::uint32_t bits, std::int32_t width, std::int32_t height, const std::string& palette,
                const std::string& rows, const std::string& masks = "") {
    const auto number = [](std::uint32_t value, unsigned bytes) {
        std::string out;
        for (unsigned i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8U * i));
        return out;
    };
    const auto size = [](const std::string& text) { return static_cast<std::uint32_t>(text.size()); };
    const std::uint32_t begin = 54 + size(masks) + size(palette);
    return "BM" + number(begin + size(rows), 4) + number(0, 4) + number(begin, 4) + number(40, 4) +
           number(static_cast<std::uint32_t>(width), 4) + number(static_cast<std::uint32_t>(height), 4) +
           number(1, 2) + number(bits, 2) + number(masks.empty() ? 0 : 3, 4) + number(size(rows), 4) +
           number(2835, 4) + number(2835, 4) + number(size(palette) / 4, 4) + number(0, 4) + masks + palette +
           rows;
}

/// Blue, green and red of one grey, and the byte that fills up.
std::string greys(const std::vector<int>& values, bool is_filled) {
    std::string out;
    for (const int value : values) {
        out += std::string(3, static_cast<char>(value));
        if (is_filled) out += '\0';
    }
    return out;
}

class PictureDepth : public PictureTest {
protected:
    /// 3 mm deep in black, on the surface in white.
    void expect_depths(const std::string& path, const std::vector<int>& greys_of_255) const {
        FlatOptions options;
        options.depth_mm = 3.0;
        const GreyImage image = read(path);
        const DepthMap map = depths(image, options);
        ASSERT_EQ(map.depth_mm.size(), greys_of_255.size()) << path;
        for (std::size_t i = 0; i < greys_of_255.size(); ++i)
            EXPECT_NEAR(map.depth_mm[i], 3.0 * (255 - greys_of_255[i]) / 255.0, kFloat_mm) << path << i;
    }
    std::string binary_pgm(const std::string& name, const Samples& samples, std::uint32_t most) const {
        std::string text = "P5\n" + std::to_string(samples.width) + " " + std::to_string(samples.height) +
                           "\n" + std::to_string(most) + "\n";
        for (const std::uint16_t value : samples.values) {
            if (most > 255) text += static_cast<char>(value >> 8U);
            text += static_cast<char>(value);
        }
        return file(name, text);
    }
    /// Grey of 16 bits, as libtiff stores it when asked so.
    std::string tiff_16(const std::string& name, const Samples& samples, const char* mode,
                        std::uint16_t packing, std::uint32_t tile_side = 0) const {
        const std::string path = file(name, "");
        TIFF* out = TIFFOpen(path.c_str(), mode);
        TIFFSetField(out, TIFFTAG_IMAGEWIDTH, samples.width);
        TIFFSetField(out, TIFFTAG_IMAGELENGTH, samples.height);
        TIFFSetField(out, TIFFTAG_BITSPERSAMPLE, 16);
        TIFFSetField(out, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(out, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(out, TIFFTAG_COMPRESSION, packing);
        std::vector<std::uint16_t> values = samples.values;
        if (tile_side == 0) {
            TIFFSetField(out, TIFFTAG_ROWSPERSTRIP, 1);
            for (std::uint32_t y = 0; y < samples.height; ++y)
                TIFFWriteScanline(out, &values[y * samples.width], y, 0);
        } else {
            TIFFSetField(out, TIFFTAG_TILEWIDTH, tile_side);
            TIFFSetField(out, TIFFTAG_TILELENGTH, tile_side);
            for (std::uint32_t y = 0; y < samples.height; y += tile_side) {
                for (std::uint32_t x = 0; x < samples.width; x += tile_side) {
                    std::vector<std::uint16_t> tile(tile_side * tile_side);
                    for (std::uint32_t i = 0; i < tile_side * tile_side; ++i) {
                        const std::uint32_t at_x = x + i % tile_side, at_y = y + i / tile_side;
                        if (at_x < samples.width && at_y < samples.height)
                            tile[i] = values[at_y * samples.width + at_x];
                    }
                    TIFFWriteTile(out, tile.data(), x, y, 0, 0);
                }
            }
        }
        TIFFClose(out);
        return path;
    }
};

/// Neighbours of 65536 greys, all of which are one grey of 256.
Samples fine_steps(std::uint32_t width = 16, std::uint32_t height = 2) {
    Samples samples{width, height, {}};
    for (std::uint32_t i = 0; i < width * height; ++i)
        samples.values.push_back(static_cast<std::uint16_t>(0x8000 + 5 * i % 256));
    return samples;
}

TEST_F(PictureDepth, SixteenBitsAreNotCutToEight) {
    const Samples samples = fine_steps();
    FlatOptions options;
    options.depth_mm = 5.0;
    for (const std::string& path :
         {pgm("text.pgm", samples), binary_pgm("binary.pgm", samples, 65535), png("fine.png", samples, 16),
          tiff_16("little.tif", samples, "wl", COMPRESSION_NONE),
          tiff_16("big.tif", samples, "wb", COMPRESSION_NONE),
          tiff_16("packed.tif", samples, "wl", COMPRESSION_ADOBE_DEFLATE)}) {
        const GreyImage image = read(path);
        EXPECT_EQ(image.values, samples.values) << path;
        EXPECT_THAT(image.format, EndsWith(", 16 bits")) << path;
        EXPECT_TRUE(image.warnings.empty()) << path;
        const DepthMap map = depths(image, options);
        ASSERT_EQ(map.depth_mm.size(), samples.values.size()) << path;
        for (std::size_t i = 0; i < samples.values.size(); ++i)
            EXPECT_NEAR(map.depth_mm[i], 5.0 * (65535 - samples.values[i]) / 65535.0, kFloat_mm) << path << i;
    }
}

TEST_F(PictureDepth, SixteenBitsReachTheBody) {
    // 40 mm round, 16 mm deep: 256 greys are steps of 0.063 mm, of which each is cut into five.
    FlatOptions options;
    options.diameter_mm = 40.0;
    options.depth_mm = 16.0;
    options.height_mm = 8.0;
    options.is_full_turn = true;
    const Samples samples{4, 1, {0x8000, 0x8033, 0x8066, 0x8099}};
    for (const std::string& path :
         {pgm("text.pgm", samples), binary_pgm("binary.pgm", samples, 65535), png("fine.png", samples, 16),
          tiff_16("fine.tif", samples, "wb", COMPRESSION_LZW)}) {
        const auto mesh = loaded(path, options);
        for (std::size_t i = 0; i < 4; ++i) {
            const double wanted_mm = 20.0 - 16.0 * (65535 - samples.values[i]) / 65535.0;
            EXPECT_NEAR(radius(mesh, 45.0 + 90.0 * static_cast<double>(i)), wanted_mm, kExact_mm)
                << path << i;
        }
    }
}

TEST_F(PictureDepth, APgmsWhiteIsWhatItSays) {
    expect_depths(file("nine.pgm", "P2 # nine\n3 1\n# greys\n5\n0 2 5\n"), {0, 102, 255});
    expect_depths(binary_pgm("five.pgm", {3, 1, {0, 2, 5}}, 5), {0, 102, 255});
    expect_depths(binary_pgm("wide.pgm", {3, 1, {0, 400, 1000}}, 1000), {0, 102, 255});
    expect_depths(binary_pgm("eight.pgm", {4, 1, {0, 1, 10, 255}}, 255), {0, 1, 10, 255});
    expect_depths(file("bits.pbm", "P1 3 1\n1 0 1\n"), {0, 255, 0});
    expect_depths(file("packed.pbm", "P4 10 2\n\xff\x80\x01\x40"),
                  {0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 255, 0});
}

TEST_F(PictureDepth, OfABmpOfAnyDepth) {
    // Rows end at whole four bytes, the lower one stands first; wanted is the upper one first.
    expect_depths(
        file("1.bmp", bmp(1, 10, 2, greys({40, 200}, true), std::string("\x80\x40\0\0\x01\x80\0\0", 8))),
        {40, 40, 40, 40, 40, 40, 40, 200, 200, 40, 200, 40, 40, 40, 40, 40, 40, 40, 40, 200});
    expect_depths(file("4.bmp", bmp(4, 3, 2, greys({0, 17, 34, 255}, true),
                                    std::string("\x01\x20\0\0\x33\x10\0\0", 8))),
                  {255, 255, 17, 0, 17, 34});
    expect_depths(
        file("8.bmp", bmp(8, 3, 2, greys({9, 99, 199}, true), std::string("\0\x01\x02\0\x02\x02\0\0", 8))),
        {199, 199, 9, 9, 99, 199});
    expect_depths(file("24.bmp", bmp(24, 3, 2, "",
                                     greys({1, 2, 3}, false) + std::string(3, '\0') +
                                         greys({250, 128, 0}, false) + std::string(3, '\0'))),
                  {250, 128, 0, 1, 2, 3});
    expect_depths(file("32.bmp", bmp(32, 2, 2, "", greys({1, 2, 250, 128}, true))), {250, 128, 1, 2});
    expect_depths(file("down.bmp", bmp(32, 2, -2, "", greys({1, 2, 250, 128}, true))), {1, 2, 250, 128});
}

TEST_F(PictureDepth, ABmpsColoursAreWhereItsMasksSay) {
    // One pixel: red 200, green 100, blue 50, and what is none of them.
    const std::string usual("\0\0\xff\0\0\xff\0\0\xff\0\0\0", 12);
    const std::string turned("\xff\0\0\0\0\xff\0\0\0\0\xff\0", 12);
    const std::string high("\0\0\0\xff\0\0\xff\0\0\xff\0\0", 12);
    const int grey = (299 * 200 + 587 * 100 + 114 * 50 + 500) / 1000;
    const auto grey_in = [this](const std::string& masks, const std::string& pixel) {
        return (read(file("masks.bmp", bmp(32, 1, 1, "", pixel, masks))).values[0] + 128) / 257;
    };
    EXPECT_EQ(grey_in(usual, std::string("\x32\x64\xc8\x07", 4)), grey);
    EXPECT_EQ(grey_in(turned, std::string("\xc8\x64\x32\x07", 4)), grey);
    EXPECT_EQ(grey_in(high, std::string("\x07\x32\x64\xc8", 4)), grey);
    const std::string narrow("\0\xf8\0\0\xe0\x07\0\0\x1f\0\0\0", 12);
    EXPECT_THAT(refusal(file("narrow.bmp", bmp(32, 1, 1, "", "abcd", narrow))),
                HasSubstr("a BMP picture of a kind that is not read"));
}

TEST_F(PictureDepth, ABmpWhosePixelsBeginInItsHeadSaysSo) {
    const std::string good = bmp(24, 3, 1, "", greys({250, 128, 0}, false) + std::string(3, '\0'));
    const auto beginning_at = [&good](std::uint32_t at) {
        std::string bytes = good;
        for (std::size_t i = 0; i < 4; ++i) bytes[10 + i] = static_cast<char>(at >> (8U * i));
        return bytes;
    };
    for (const std::uint32_t at : {0U, 14U, 53U}) {
        EXPECT_THAT(refusal(file("in.bmp", beginning_at(at))),
                    EndsWith("a damaged BMP picture: its pixels are said to begin at byte " +
                             std::to_string(at) + ", inside its head of 54"));
    }
    for (const std::uint32_t at : {55U, 1000U}) {
        EXPECT_THAT(refusal(file("out.bmp", beginning_at(at))),
                    EndsWith("a damaged BMP picture: the file ends too early"));
    }
}

TEST_F(PictureDepth, OfAGreyJpegIsThatOfItsFlatPlaces) {
    Samples samples{32, 8, {}};
    constexpr std::array kGreys{0, 60, 190, 255};
    for (std::uint32_t i = 0; i < 32 * 8; ++i)
        samples.values.push_back(static_cast<std::uint16_t>(kGreys[i % 32 / 8] * 257));
    FlatOptions options;
    options.depth_mm = 3.0;
    const GreyImage image = read(jpeg("flat.jpg", samples));
    EXPECT_TRUE(image.warnings.empty());
    const DepthMap map = depths(image, options);
    for (std::size_t k = 0; k < kGreys.size(); ++k)
        EXPECT_NEAR(map.at(8 * k + 4, 4), 3.0 * (255 - kGreys[k]) / 255.0, 3.0 / 255.0 + kFloat_mm) << k;
}

TEST_F(PictureDepth, OfATiffInTilesOrTurnedIsNotCutToEightBitsEither) {
    const Samples samples = fine_steps(20, 18);
    const GreyImage tiled = read(tiff_16("tiles.tif", samples, "wl", COMPRESSION_LZW, 16));
    EXPECT_EQ(tiled.values, samples.values);
    EXPECT_EQ(tiled.format, "TIFF, 16 bits");
    EXPECT_TRUE(tiled.warnings.empty());
    const std::string path = tiff_16("turned.tif", fine_steps(4, 2), "wl", COMPRESSION_NONE);
    const auto as_turned = [&path](std::uint16_t orientation) {
        TIFF* turned = TIFFOpen(path.c_str(), "r+");
        TIFFSetField(turned, TIFFTAG_ORIENTATION, orientation);
        TIFFRewriteDirectory(turned);
        TIFFClose(turned);
        return read(path);
    };
    const auto v = fine_steps(4, 2).values;
    EXPECT_EQ(as_turned(ORIENTATION_BOTLEFT).values,
              (std::vector<std::uint16_t>{v[4], v[5], v[6], v[7], v[0], v[1], v[2], v[3]}));
    const GreyImage on_its_side = as_turned(ORIENTATION_RIGHTTOP);
    EXPECT_EQ(on_its_side.width, 2U);
    EXPECT_EQ(on_its_side.values,
              (std::vector<std::uint16_t>{v[4], v[0], v[5], v[1], v[6], v[2], v[7], v[3]}));
}

TEST_F(PictureDepth, OfATiffInColourStandsUprightAsWell) {
    const std::string path = file("colour.tif", "");
    TIFF* out = TIFFOpen(path.c_str(), "wl");
    TIFFSetField(out, TIFFTAG_IMAGEWIDTH, 2);
    TIFFSetField(out, TIFFTAG_IMAGELENGTH, 1);
    TIFFSetField(out, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(out, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(out, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(out, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(out, TIFFTAG_ORIENTATION, ORIENTATION_LEFTBOT);
    std::array<std::uint8_t, 6> row{10, 10, 10, 200, 200, 200};
    TIFFWriteScanline(out, row.data(), 0, 0);
    TIFFClose(out);
    // The first row is the left side, its first pixel at the bottom.
    const GreyImage image = read(path);
    EXPECT_EQ(image.width, 1U);
    EXPECT_EQ(image.height, 2U);
    EXPECT_EQ(image.values, (std::vector<std::uint16_t>{200 * 257, 10 * 257}));
}

}  // namespace
}  // namespace psicarve::flat
