// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/hmi/flat/picture_files.hpp"
#include "tests/places.hpp"

namespace psicarve::flat {
namespace {

using testing::EndsWith;

class PictureReader : public PictureTest {
protected:
    /// The content of a camera's marker, high or low byte first, with another entry before the one that
    /// counts.
    static std::string exif(int orientation, bool is_big = true) {
        const auto number = [is_big](std::uint32_t value, int bytes) {
            std::string out;
            for (int i = 0; i < bytes; ++i)
                out += static_cast<char>(value >> 8U * static_cast<unsigned>(is_big ? bytes - 1 - i : i));
            return out;
        };
        const auto entry = [&number](std::uint32_t tag, int value) {
            return number(tag, 2) + number(3, 2) + number(1, 4) +
                   number(static_cast<std::uint32_t>(value), 2) + number(0, 2);
        };
        return std::string("Exif\0\0", 6) + (is_big ? "MM" : "II") + number(42, 2) + number(8, 4) +
               number(2, 2) + entry(0x0100, 5) + entry(0x0112, orientation);
    }
    /// A picture of paper that is seen through four inks, as Adobe's programs store it.
    std::string ink_jpeg(const std::string& name, const std::vector<std::uint8_t>& pixels,
                         bool is_adobe) const {
        const std::string path = file(name, "");
        std::FILE* out = std::fopen(path.c_str(), "wb");
        jpeg_compress_struct state{};
        jpeg_error_mgr errors{};
        state.err = jpeg_std_error(&errors);
        jpeg_create_compress(&state);
        jpeg_stdio_dest(&state, out);
        state.image_width = static_cast<JDIMENSION>(pixels.size() / 4);
        state.image_height = 1;
        state.input_components = 4;
        state.in_color_space = JCS_CMYK;
        jpeg_set_defaults(&state);
        state.write_Adobe_marker = is_adobe ? TRUE : FALSE;
        jpeg_set_quality(&state, 100, TRUE);
        jpeg_start_compress(&state, TRUE);
        std::vector<std::uint8_t> copy = pixels;
        JSAMPROW row = copy.data();
        jpeg_write_scanlines(&state, &row, 1);
        jpeg_finish_compress(&state);
        jpeg_destroy_compress(&state);
        std::fclose(out);
        return path;
    }
    /// A TIFF of 16 x 16 grey pixels whose directory stands before them; `kept` of their bytes are there.
    static std::string tiff_cut_at(std::size_t kept) {
        const auto number = [](std::uint32_t value, int bytes) {
            std::string out;
            for (int i = 0; i < bytes; ++i)
                out += static_cast<char>(value >> (8U * static_cast<unsigned>(i)));
            return out;
        };
        constexpr std::array<std::array<std::uint32_t, 2>, 9> kEntries{{{256, 16},
                                                                        {257, 16},
                                                                        {258, 8},
                                                                        {259, 1},
                                                                        {262, 1},
                                                                        {273, 122},
                                                                        {277, 1},
                                                                        {278, 16},
                                                                        {279, 256}}};
        std::string out = std::string("II*\0", 4) + number(8, 4) + number(9, 2);
        for (const auto& [tag, value] : kEntries)
            out += number(tag, 2) + number(4, 2) + number(1, 4) + number(value, 4);
        return out + number(0, 4) + std::string(kept, 'x');
    }
};

TEST_F(PictureReader, AJpegStandsAsTheCameraWasHeld) {
    // Corners a b over c d, dark to bright, 16 x 8 pixels each.
    Samples samples{32, 16, {}};
    for (std::uint32_t y = 0; y < 16; ++y) {
        for (std::uint32_t x = 0; x < 32; ++x) {
            samples.values.push_back(
                static_cast<std::uint16_t>(257 * (x < 16 ? (y < 8 ? 20 : 140) : (y < 8 ? 80 : 200))));
        }
    }
    const std::array<const char*, 9> corners{"abcd", "abcd", "badc", "dcba", "cdab",
                                             "acbd", "cadb", "dbca", "bdac"};
    for (int orientation = 0; orientation <= 8; ++orientation) {
        for (const bool is_big : {true, false}) {
            const GreyImage image = read(jpeg("a.jpg", samples, exif(orientation, is_big)));
            ASSERT_EQ(image.width, orientation >= 5 ? 16U : 32U);
            ASSERT_EQ(image.height, orientation >= 5 ? 32U : 16U);
            std::string seen;
            for (const auto& [x, y] : {std::pair{0U, 0U}, {1U, 0U}, {0U, 1U}, {1U, 1U}}) {
                const auto value =
                    image.values[(y * (image.height - 1)) * image.width + x * (image.width - 1)] / 257;
                seen += static_cast<char>('a' + (value - 10) / 60);
            }
            EXPECT_EQ(seen, corners[static_cast<std::size_t>(orientation)]) << orientation;
        }
    }
}

TEST_F(PictureReader, ADamagedCamerasMarkerTurnsNothing) {
    const Samples samples = ramp();
    const std::string whole = exif(6);
    for (std::size_t length = 1; length < whole.size() - 2; ++length) {
        EXPECT_EQ(read(jpeg("a.jpg", samples, whole.substr(0, length))).width, samples.width) << length;
    }
    EXPECT_EQ(read(jpeg("a.jpg", samples, exif(9))).width, samples.width);
    EXPECT_EQ(read(jpeg("a.jpg", samples, whole)).width, samples.height);
    std::string far = whole;
    for (std::size_t i = 10; i < 14; ++i) far[i] = '\xff';
    EXPECT_EQ(read(jpeg("a.jpg", samples, far)).width, samples.width);
}

TEST_F(PictureReader, AJpegOfFourInksIsAsBrightAsItsPaper) {
    // White, black by black ink, black by all colours, half of all colours.
    std::vector<std::uint8_t> inks;
    for (const auto& pixel :
         {std::array<std::uint8_t, 4>{0, 0, 0, 0}, {0, 0, 0, 255}, {255, 255, 255, 0}, {128, 128, 128, 0}}) {
        for (int k = 0; k < 8; ++k) inks.insert(inks.end(), pixel.begin(), pixel.end());
    }
    std::vector<std::uint8_t> paper;
    for (const auto ink : inks) paper.push_back(static_cast<std::uint8_t>(255 - ink));
    for (const bool is_adobe : {false, true}) {
        const GreyImage image = read(ink_jpeg("i.jpg", is_adobe ? paper : inks, is_adobe));
        EXPECT_EQ(image.format, "JPEG");
        EXPECT_EQ(image.warnings.size(), 1U);
        const std::array<int, 4> wanted{255, 0, 0, 127};
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(image.values[8 * i + 4] / 257, wanted[i], 3) << is_adobe << i;
    }
}

TEST_F(PictureReader, OfOtherPicturesItSaysWhatTheyAreAndWhatHelps) {
    for (const char* name : {"p.png", "p.gif", "p"}) {
        EXPECT_THAT(refusal(file(name, "GIF89a and more")),
                    EndsWith("a GIF picture, which is not read; save it as PNG"));
        EXPECT_THAT(refusal(file(name, std::string("RIFF\1\2\3\4WEBPVP8 ", 16))),
                    EndsWith("a WebP picture, which is not read; save it as PNG"));
    }
    EXPECT_THAT(refusal(file("a.svg", "\x1f\x8b\x08 and more")),
                EndsWith("a packed file (gzip), as SVGZ is; unpack it first"));
    EXPECT_THAT(
        refusal(file("a.foo", "what is this")),
        EndsWith("nothing that can be read here: a mesh (STL, OBJ, PLY, 3MF, OFF), a drawing (SVG, DXF), a "
                 "picture (PNG, JPEG, TIFF, BMP, PGM) or a table (CSV)"));
}

TEST_F(PictureReader, ATiffCutShortIsSaidToBeThat) {
    EXPECT_EQ(read(file("whole.tif", tiff_cut_at(256))).values.size(), 256U);
    for (const std::size_t kept : {0U, 1U, 100U, 255U}) {
        EXPECT_THAT(refusal(file("cut.tif", tiff_cut_at(kept))),
                    EndsWith("a damaged TIFF picture: the file ends too early"))
            << kept;
    }
    // This one's directory stands behind its pixels.
    const std::string behind = bytes_of(in_source("tests/fuzz/corpus/picture/grey16.tif"));
    for (std::size_t kept = 4; kept < behind.size(); ++kept) {
        EXPECT_THAT(refusal(file("cut.tif", behind.substr(0, kept))),
                    EndsWith("a damaged TIFF picture: the file ends too early"))
            << kept;
    }
}

// Only from pictures that are read does the fuzzer come to what is done with them.
TEST_F(PictureReader, ReadsWhatItsFuzzerBeginsWith) {
    std::set<std::string> formats;
    for (const auto& entry : std::filesystem::directory_iterator(in_source("tests/fuzz/corpus/picture"))) {
        const GreyImage image = read(entry.path().string());
        EXPECT_GT(image.values.size(), 1U) << entry.path();
        formats.insert(image.format);
    }
    EXPECT_THAT(formats, testing::IsSupersetOf({"BMP", "JPEG", "PGM, 8 bits", "PNG, 8 bits", "PNG, 16 bits",
                                                "TIFF, 8 bits", "TIFF, 16 bits"}));
}

}  // namespace
}  // namespace psicarve::flat
