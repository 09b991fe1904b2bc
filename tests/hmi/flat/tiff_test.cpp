// SPDX-License-Identifier: GPL-3.0-or-later
// What a TIFF may hold: the same greys and radii as the PNG of the same samples, or a line that says what it
// is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "tests/hmi/flat/picture_files.hpp"

namespace psicarve::flat {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr std::array<std::uint16_t, 5> kAlphas{65535, 0, 32768, 300, 51234};

class Tiff : public PictureTest {
protected:
    /// Samples all of whose bits tell; the last of an even count is an alpha.
    static Samples pixels(std::uint32_t samples, std::uint32_t width = 20, std::uint32_t height = 18) {
        Samples all{width, height, {}};
        for (std::uint32_t i = 0; i < width * height * samples; ++i) {
            const bool is_alpha = samples % 2 == 0 && i % samples == samples - 1;
            all.values.push_back(is_alpha ? kAlphas[i / samples % kAlphas.size()]
                                          : static_cast<std::uint16_t>(i * 2654435761U >> 16U));
        }
        return all;
    }
    /// As an associated alpha stores them.
    static Samples multiplied(const Samples& from, std::uint32_t samples, std::uint16_t bits) {
        const std::uint32_t shift = 16U - bits, one = (1U << bits) - 1U;
        Samples out = from;
        for (std::size_t i = 0; i < out.values.size(); ++i) {
            const std::size_t pixel = i / samples * samples;
            if (i % samples == samples - 1) continue;
            const std::uint32_t a = std::uint32_t{from.values[pixel + samples - 1]} >> shift;
            const std::uint32_t v = std::uint32_t{from.values[i]} >> shift;
            out.values[i] = static_cast<std::uint16_t>((v * a + one / 2) / one << shift);
        }
        return out;
    }
    static TiffKind kind(std::uint16_t samples, std::uint16_t bits) {
        TiffKind made;
        made.bits = bits;
        made.samples = samples;
        made.photometric = samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK;
        if (samples % 2 == 0) made.extra = {EXTRASAMPLE_UNASSALPHA};
        return made;
    }
    static std::string kind_name(int samples, int bits) {
        return std::to_string(samples) + "_" + std::to_string(bits);
    }
    /// The file with another value in an entry of its one directory, which is little-endian.
    static std::string with_entry(std::string bytes, std::uint32_t tag, std::uint32_t value) {
        const auto number = [&bytes](std::size_t at, std::size_t count) {
            std::uint32_t out = 0;
            for (std::size_t i = 0; i < count; ++i)
                out |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8U * i);
            return out;
        };
        const std::size_t directory = number(4, 4);
        for (std::size_t entry = 0; entry < number(directory, 2); ++entry) {
            const std::size_t at = directory + 2 + 12 * entry;
            if (number(at, 2) != tag) continue;
            for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + i] = static_cast<char>(value >> (8U * i));
            return bytes;
        }
        ADD_FAILURE() << "no entry " << tag;
        return bytes;
    }
};

TEST_F(Tiff, OfOneToFourSamplesIsAsThePngOfTheSameSamples) {
    for (const std::uint16_t samples : std::initializer_list<std::uint16_t>{1, 2, 3, 4}) {
        for (const std::uint16_t bits : std::initializer_list<std::uint16_t>{8, 16}) {
            const Samples all = pixels(samples);
            const std::string name = kind_name(samples, bits);
            const GreyImage wanted = read(png_of(name + ".png", all, samples, bits));
            TiffKind made = kind(samples, bits);
            for (const std::uint32_t tile_side : {0U, 16U}) {
                for (const char* mode : {"wl", "wb"}) {
                    made.tile_side = tile_side;
                    made.mode = mode;
                    const GreyImage image = read(tiff_of(name + ".tif", all, made));
                    EXPECT_EQ(image.values, wanted.values) << name << mode << tile_side;
                    EXPECT_EQ(image.format, bits == 16 ? "TIFF, 16 bits" : "TIFF, 8 bits") << name;
                    EXPECT_EQ(image.warnings, wanted.warnings) << name;
                }
            }
        }
    }
}

TEST_F(Tiff, HasThePngsRadii) {
    FlatOptions options;
    options.depth_mm = 16.0;
    options.height_mm = 8.0;
    options.is_full_turn = true;
    for (const std::uint16_t samples : std::initializer_list<std::uint16_t>{2, 3}) {
        const Samples all = pixels(samples, 4, 1);
        const auto from_png = loaded(png_of("a.png", all, samples, 16), options);
        const auto from_tiff = loaded(tiff_of("a.tif", all, kind(samples, 16)), options);
        for (const double direction_deg : {45.0, 135.0, 225.0, 315.0}) {
            EXPECT_EQ(radius(from_tiff, direction_deg), radius(from_png, direction_deg)) << samples;
            EXPECT_GT(radius(from_tiff, direction_deg), 3.0);
        }
    }
}

TEST_F(Tiff, OfAssociatedAlphaLooksAsThatOfUnassociated) {
    for (const std::uint16_t samples : std::initializer_list<std::uint16_t>{2, 4}) {
        for (const std::uint16_t bits : std::initializer_list<std::uint16_t>{8, 16}) {
            const Samples all = pixels(samples);
            TiffKind made = kind(samples, bits);
            const GreyImage wanted = read(tiff_of("apart.tif", all, made));
            made.extra = {EXTRASAMPLE_ASSOCALPHA};
            const GreyImage image = read(tiff_of("with.tif", multiplied(all, samples, bits), made));
            ASSERT_EQ(image.values.size(), wanted.values.size());
            for (std::size_t i = 0; i < wanted.values.size(); ++i)
                ASSERT_NEAR(image.values[i], wanted.values[i], bits == 8 ? 257 : 1) << samples << bits << i;
        }
    }
}

TEST_F(Tiff, OfInkIsWhereItIsTransparentWhiteAsWell) {
    const Samples all{3, 1, {10'001, 65535, 10'001, 0, 40'000, 32768}};
    TiffKind made = kind(2, 16);
    made.photometric = PHOTOMETRIC_MINISWHITE;
    const std::vector<std::uint16_t> wanted{55534, 65535, 65535 - 20'000};
    const auto expect_near = [&](const GreyImage& image) {
        ASSERT_EQ(image.values.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(image.values[i], wanted[i], 1) << i;
    };
    expect_near(read(tiff_of("ink.tif", all, made)));
    made.extra = {EXTRASAMPLE_ASSOCALPHA};
    expect_near(read(tiff_of("ink.tif", multiplied(all, 2, 16), made)));
}

TEST_F(Tiff, WhoseSecondSampleIsNoAlphaIsNotSeenThrough) {
    const Samples all = pixels(2);
    TiffKind made = kind(2, 16);
    made.extra = {EXTRASAMPLE_UNSPECIFIED};
    const GreyImage image = read(tiff_of("other.tif", all, made));
    ASSERT_EQ(image.values.size(), all.values.size() / 2);
    for (std::size_t i = 0; i < image.values.size(); ++i) EXPECT_EQ(image.values[i], all.values[2 * i]);
}

TEST_F(Tiff, OfFourSamplesWhoseLastIsNotNamedSaysWhatItIsTakenFor) {
    TiffKind made = kind(4, 16);
    made.extra = {EXTRASAMPLE_ASSOCALPHA};
    const Samples all = multiplied(pixels(4), 4, 16);
    const GreyImage wanted = read(tiff_of("named.tif", all, made));
    made.extra = {EXTRASAMPLE_UNSPECIFIED};
    const GreyImage image = read(tiff_of("bare.tif", all, made));
    EXPECT_EQ(image.values, wanted.values);
    EXPECT_EQ(image.warnings, (std::vector<std::string>{
                                  "the picture is in colour; its brightness is taken",
                                  "the picture does not say what its fourth sample is: taken as alpha"}));
}

TEST_F(Tiff, InPlanesIsTakenInEightBitsAndSaysSo) {
    TiffKind made = kind(3, 16);
    made.planes = PLANARCONFIG_SEPARATE;
    const Samples all = pixels(3);
    const GreyImage image = read(tiff_of("planes.tif", all, made));
    EXPECT_EQ(image.format, "TIFF, 8 bits");
    EXPECT_THAT(image.warnings,
                testing::Contains("of the picture's 16 bits 8 are taken, as its samples lie in planes"));
    const GreyImage whole = read(tiff_of("whole.tif", all, kind(3, 16)));
    for (std::size_t i = 0; i < whole.values.size(); ++i)
        ASSERT_NEAR(image.values[i], whole.values[i], 257) << i;
}

TEST_F(Tiff, OfAnotherDepthIsRefusedByThatAndNotAsDamaged) {
    TiffKind made = kind(1, 32);
    EXPECT_THAT(refusal(tiff_of("wide.tif", pixels(1), made)),
                EndsWith("wide.tif: a TIFF picture of 32 bits a sample: 8 or 16 are read"));
    made.bits = 64;
    EXPECT_THAT(refusal(tiff_of("wide.tif", pixels(1), made)),
                EndsWith("64 bits a sample: 8 or 16 are read"));
    const std::string grey = bytes_of(tiff_of("grey.tif", pixels(1), kind(1, 8)));
    EXPECT_THAT(refusal(file("twelve.tif", with_entry(grey, TIFFTAG_BITSPERSAMPLE, 12))),
                EndsWith("12 bits a sample: 8 or 16 are read"));
}

TEST_F(Tiff, OfAnotherKindIsRefusedByThatInWordsThatAreNotLibtiffs) {
    const std::string grey = bytes_of(tiff_of("grey.tif", pixels(1), kind(1, 8)));
    EXPECT_THAT(refusal(file("kind.tif", with_entry(grey, TIFFTAG_PHOTOMETRIC, 7777))),
                EndsWith("a TIFF picture of a kind that is not read (1 samples of 8 bits, photometric 7777); "
                         "save it as PNG"));
    EXPECT_THAT(refusal(file("few.tif", with_entry(grey, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB))),
                HasSubstr("of a kind that is not read (1 samples of 8 bits, photometric 2)"));
    EXPECT_THAT(refusal(file("packed.tif", with_entry(grey, TIFFTAG_COMPRESSION, 34712))),
                EndsWith("packed in a way that is not read (compression 34712); save it as PNG"));
    // Red, green and blue of 5, 6 and 5 bits.
    std::string uneven = bytes_of(tiff_of("colour.tif", pixels(3), kind(3, 8)));
    const std::string eights("\x08\0\x08\0\x08\0", 6);
    const std::size_t at = uneven.rfind(eights);
    ASSERT_NE(at, std::string::npos);
    uneven.replace(at, eights.size(), std::string("\x05\0\x06\0\x05\0", 6));
    EXPECT_THAT(refusal(file("uneven.tif", uneven)),
                EndsWith("a TIFF picture whose samples are of different sizes; save it as PNG"));
}

TEST_F(Tiff, WhoseOrientationIsNoneThatThereIsStandsAsItIsStored) {
    for (const std::uint16_t samples : std::initializer_list<std::uint16_t>{1, 3}) {
        TiffKind made = kind(samples, 8);
        const std::string path = tiff_of("upright.tif", pixels(samples), made);
        TIFF* out = TIFFOpen(path.c_str(), "r+");
        TIFFSetField(out, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
        TIFFRewriteDirectory(out);
        TIFFClose(out);
        const std::string bytes = bytes_of(path);
        const GreyImage wanted = read(path);
        for (const std::uint32_t orientation : {0U, 9U, 99U}) {
            const GreyImage image =
                read(file("odd.tif", with_entry(bytes, TIFFTAG_ORIENTATION, orientation)));
            EXPECT_EQ(image.values, wanted.values) << orientation;
            EXPECT_EQ(image.width, wanted.width);
        }
    }
}

TEST_F(Tiff, ThatIsDamagedSaysWhereInPlainWords) {
    std::string torn = bytes_of(tiff_of("torn.tif", pixels(1), kind(1, 16)));
    for (std::size_t i = 8; i < 200; ++i) torn[i] = '\xff';  // the packed rows
    EXPECT_THAT(refusal(file("torn.tif", torn)),
                EndsWith("a damaged TIFF picture: its pixels cannot be unpacked"));
    EXPECT_THAT(
        refusal(file("none.tif", std::string("II*\0\x08\0\0\0\x01\0\0\1\4\0\0\0\0\0\0\0\0\0\0\0\0\0", 26))),
        HasSubstr("none.tif: a"));
}

}  // namespace
}  // namespace psicarve::flat
