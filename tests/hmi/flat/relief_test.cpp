// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/relief.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/hmi/flat/picture_files.hpp"

namespace psicarve::flat {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class Relief : public PictureTest {
protected:
    /// A ring of one row: the grey of each sample, over a cylinder of 20 mm diameter, 10 mm high.
    static GreyImage ring(const std::vector<std::uint16_t>& values) {
        return {values.size(), 1, values, "test", {}};
    }
};

TEST_F(Relief, SixteenBitsArriveAsTheyStand) {
    const Samples samples = ramp();
    EXPECT_EQ(read(pgm("a.pgm", samples)).values, samples.values);
    EXPECT_EQ(read(png("a.png", samples, 16)).values, samples.values);
    EXPECT_EQ(read(tiff("a.tiff", samples, 16)).values, samples.values);
    EXPECT_EQ(read(png("b.png", samples, 16)).format, "PNG, 16 bits");
}

TEST_F(Relief, EightBitsAreSpreadOverTheWholeRange) {
    const Samples samples = ramp();
    std::vector<std::uint16_t> wanted;
    for (const auto value : samples.values) wanted.push_back(static_cast<std::uint16_t>(value / 257 * 257));
    EXPECT_EQ(read(png("a.png", samples, 8)).values, wanted);
    EXPECT_EQ(read(tiff("a.tif", samples, 8)).values, wanted);
    const GreyImage image = read(jpeg("a.jpg", samples));
    ASSERT_EQ(image.values.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(image.values[i], wanted[i], 3 * 257) << i;
}

TEST_F(Relief, ABmpStandsOnItsFeetAndKnowsItsPalette) {
    // 2 x 2, 8 bits: the lower row comes first. Entries 0 black, 1 white, 2 grey.
    std::string bmp("BM\0\0\0\0\0\0\0\0\x42\0\0\0\x28\0\0\0\x02\0\0\0\x02\0\0\0\x01\0\x08\0\0\0\0\0", 34);
    bmp += std::string(12, '\0') + std::string("\x03\0\0\0", 4) + std::string(4, '\0');
    bmp += std::string("\0\0\0\0\xff\xff\xff\0\x80\x80\x80\0", 12);
    bmp += std::string("\x02\x02\0\0\x00\x01\0\0", 8);
    const GreyImage image = read(file("a.bmp", bmp));
    EXPECT_EQ(image.values, (std::vector<std::uint16_t>{0, 65535, 0x8080, 0x8080}));
    EXPECT_THAT(refusal(file("b.bmp", bmp.substr(0, bmp.size() - 1))),
                EndsWith("a damaged BMP picture: the file ends too early"));
}

TEST_F(Relief, DepthsRunFromWhiteToBlack) {
    FlatOptions options;
    options.depth_mm = 3.0;
    options.white_depth_mm = 1.0;
    options.diameter_mm = 20.0;
    const DepthMap map = depths(ring({0, 65535, 32768}), options);
    EXPECT_NEAR(map.at(0, 0), 3.0, 1e-6);
    EXPECT_NEAR(map.at(1, 0), 1.0, 1e-6);
    EXPECT_NEAR(map.at(2, 0), 2.0, 1e-4);
    EXPECT_NEAR(map.height_mm, 20.0 * kPi / 3.0, 1e-9);
    options.is_inverted = true;
    EXPECT_NEAR(depths(ring({0, 65535, 32768}), options).at(0, 0), 1.0, 1e-6);
}

TEST_F(Relief, GammaIsAPowerOfTheBrightness) {
    FlatOptions options;
    options.depth_mm = 1.0;
    options.gamma = 2.0;
    EXPECT_NEAR(depths(ring({16384, 65535}), options).at(0, 0), 1.0 - 0.0625, 1e-4);
}

TEST_F(Relief, TheBodyHasEachSamplesRadiusWhereItStands) {
    FlatOptions options;
    options.depth_mm = 4.0;
    options.diameter_mm = 20.0;
    options.height_mm = 30.0;
    options.is_full_turn = true;
    // Four samples across, three down: in the middle of their cells, the first row on top.
    Samples samples{4, 3, {0, 65535, 65535, 65535, 65535, 0, 65535, 65535, 65535, 65535, 0, 65535}};
    const auto mesh = loaded(pgm("a.pgm", samples), options);
    EXPECT_TRUE(mesh.facts.closed);
    EXPECT_DOUBLE_EQ(mesh.facts.max[2], 30.0);
    EXPECT_NEAR(radius(mesh, 45, 25.0 / 30.0), 6.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 135, 25.0 / 30.0), 10.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 135, 15.0 / 30.0), 6.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 225, 5.0 / 30.0), 6.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 45, 29.0 / 30.0), 6.0, kExact_mm);  // up to the edge
    EXPECT_NEAR(radius(mesh, 135, 20.0 / 30.0), 8.0, 1e-3);      // half-way between samples
    EXPECT_NEAR(radius(mesh, 0, 25.0 / 30.0), 8.0, 0.01);        // and across the seam
}

TEST_F(Relief, AHeightKeepsTheShapeAndLeavesTheRestWhite) {
    FlatOptions options;
    options.diameter_mm = 20.0;
    options.height_mm = 5.0 * kPi;  // as high as wide: a quarter of the turn
    const auto mesh = loaded(pgm("a.pgm", {2, 2, {0, 0, 0, 0}}), options);
    EXPECT_NEAR(radius(mesh, 45), 8.0, kCurve_mm);
    EXPECT_NEAR(radius(mesh, 89), 8.0, kCurve_mm);
    EXPECT_NEAR(radius(mesh, 92), 10.0, kCurve_mm);
    EXPECT_NEAR(radius(mesh, 270), 10.0, kCurve_mm);
    options.height_mm = 70.0;
    EXPECT_THAT(
        refusal(pgm("a.pgm", {2, 2, {0, 0, 0, 0}}), options),
        HasSubstr("a picture 70.00 mm high would be 70.00 mm wide, and once round are only 62.83 mm"));
}

TEST_F(Relief, ASeamIsToldOfOrBlended) {
    std::vector<std::uint16_t> values;
    for (int i = 0; i < 100; ++i) values.push_back(static_cast<std::uint16_t>(i * 660));
    FlatOptions options;
    options.depth_mm = 2.0;
    const DepthMap plain = depths(ring(values), options);
    ASSERT_EQ(plain.warnings.size(), 1U);
    EXPECT_THAT(plain.warnings[0],
                HasSubstr("a step of up to 1.99 mm at direction 0; --seam blend makes it smooth"));
    options.blends_seam = true;
    const DepthMap blended = depths(ring(values), options);
    EXPECT_TRUE(blended.warnings.empty());
    EXPECT_NEAR(blended.at(0, 0), blended.at(99, 0), 1e-6);
    EXPECT_NEAR(blended.at(0, 0), 0.5 * (plain.at(0, 0) + plain.at(99, 0)), 1e-6);
    EXPECT_FLOAT_EQ(blended.at(5, 0), plain.at(5, 0));
    EXPECT_FLOAT_EQ(blended.at(94, 0), plain.at(94, 0));
    std::vector<std::uint16_t> waves;
    for (int i = 0; i < 100; ++i)
        waves.push_back(static_cast<std::uint16_t>(30000 + 20000 * std::sin(0.0628318 * i)));
    options.blends_seam = false;
    EXPECT_TRUE(depths(ring(waves), options).warnings.empty());
}

TEST_F(Relief, OfASmallPictureTheSeamIsToldAsWell) {
    FlatOptions options;
    options.depth_mm = 2.0;
    for (const std::array<std::uint16_t, 4>& row :
         {std::array<std::uint16_t, 4>{0, 0, 65535, 65535}, {0, 65535, 0, 65535}, {65535, 0, 0, 0}}) {
        GreyImage image{4, 4, {}, "test", {}};
        for (int y = 0; y < 4; ++y) image.values.insert(image.values.end(), row.begin(), row.end());
        const DepthMap map = depths(image, options);
        ASSERT_EQ(map.warnings.size(), 1U);
        EXPECT_THAT(map.warnings[0], HasSubstr("do not meet: a step of up to 2.00 mm at direction 0"));
    }
}

TEST_F(Relief, ASeamThatStepsInAThirdOfItsHeightIsToldOf) {
    GreyImage image{90, 30, {}, "test", {}};
    for (std::size_t y = 0; y < 30; ++y) {
        for (std::size_t x = 0; x < 90; ++x) {
            // Ripples of 0.4 mm that close, and in ten rows the last third of the picture is lower.
            const double grey = 40'000.0 + 6554.0 * std::sin(2.0 * kPi * static_cast<double>(x) / 10.0);
            const bool is_low = y >= 20 && x >= 60;
            image.values.push_back(static_cast<std::uint16_t>(grey - (is_low ? 16'384.0 : 0.0)));
        }
    }
    FlatOptions options;
    options.depth_mm = 2.0;
    const DepthMap map = depths(image, options);
    ASSERT_EQ(map.warnings.size(), 1U);
    EXPECT_THAT(map.warnings[0], HasSubstr("do not meet"));
}

TEST_F(Relief, ASeamThatIsLikeTheRestOfThePictureIsNotToldOf) {
    FlatOptions options;
    options.depth_mm = 10.0;
    std::mt19937 random(5);
    GreyImage noise{60, 60, {}, "test", {}};
    for (int i = 0; i < 3600; ++i) noise.values.push_back(static_cast<std::uint16_t>(random() >> 16U));
    EXPECT_TRUE(depths(noise, options).warnings.empty());
    // As steep at the seam as anywhere.
    std::vector<std::uint16_t> waves;
    for (int i = 0; i < 100; ++i)
        waves.push_back(static_cast<std::uint16_t>(32767 + 32767 * std::sin(0.02 * kPi * i)));
    EXPECT_TRUE(depths(ring(waves), options).warnings.empty());
    // Two greys of 256, which 10 mm of depth make 0.08 mm.
    std::vector<std::uint16_t> coarse(100, 40 * 257);
    for (std::size_t i = 50; i < 100; ++i) coarse[i] = 42 * 257;
    EXPECT_TRUE(depths(ring(coarse), options).warnings.empty());
}

TEST_F(Relief, EdgesThatAreNotWhiteAreToldOfWhereARestIsLeft) {
    FlatOptions options;
    options.depth_mm = 2.0;
    options.height_mm = 10.0;
    const auto patch = [&](std::uint16_t left, std::uint16_t right) {
        GreyImage image{6, 6, {}, "test", {}};
        for (int y = 0; y < 6; ++y) {
            for (const std::uint16_t value : {left, left, std::uint16_t{30'000}, right, right, right})
                image.values.push_back(value);
        }
        return depths(image, options).warnings;
    };
    EXPECT_THAT(
        patch(0, 32768),
        testing::ElementsAre("the picture ends before the full turn in steps to the white rest: of up "
                             "to 2.00 mm at its left edge and 1.00 mm at its right one; white edges or "
                             "--full-turn leave none"));
    EXPECT_THAT(patch(65535, 32768), testing::ElementsAre(HasSubstr("0.00 mm at its left edge and 1.00")));
    EXPECT_THAT(patch(65535, 65535), testing::IsEmpty());
    options.blends_seam = true;  // which blends nothing there
    EXPECT_THAT(patch(65535, 0), testing::ElementsAre(HasSubstr("2.00 mm at its right one")));
    options.is_full_turn = true;
    EXPECT_THAT(patch(0, 32768), testing::IsEmpty());
}

TEST_F(Relief, SmoothingIsAGaussianThatGoesRoundTheSeam) {
    std::vector<std::uint16_t> values(200, 65535);
    values[0] = 0;
    FlatOptions options;
    options.depth_mm = 1.0;
    options.diameter_mm = 200.0 / kPi;  // a millimetre a sample
    options.smooth_mm = 2.0;
    const DepthMap map = depths(ring(values), options);
    double sum = 0.0;
    for (std::size_t i = 0; i < 200; ++i) sum += map.at(i, 0);
    EXPECT_NEAR(sum, 1.0, 1e-4);
    EXPECT_NEAR(map.at(2, 0) / map.at(0, 0), std::exp(-0.5), 1e-4);
    EXPECT_FLOAT_EQ(map.at(198, 0), map.at(2, 0));
}

TEST_F(Relief, LargePicturesAreAveraged) {
    std::string text = "P5 4000 2000 255\n";
    for (int i = 0; i < 8'000'000; ++i) text += i % 2 == 0 ? '\0' : '\xff';
    const DepthMap map = depths(read(file("l.pgm", text)), {});
    EXPECT_EQ(map.width, 2000U);
    EXPECT_NEAR(map.at(77, 5), 1.0, 1e-6);
    ASSERT_FALSE(map.warnings.empty());
    EXPECT_EQ(map.warnings[0], "the picture's 4000 x 2000 pixels are averaged to 2000 x 1000");
}

TEST_F(Relief, TooDeepIsRefused) {
    FlatOptions options;
    options.depth_mm = 10.0;
    options.diameter_mm = 20.0;
    EXPECT_THAT(refusal(pgm("a.pgm", ramp()), options),
                EndsWith("10.00 mm deep goes to the middle of a cylinder of 20.00 mm diameter"));
}

TEST_F(Relief, EveryTruncationAndHugeSizesAreOneLine) {
    const Samples samples = ramp();
    for (const std::string& path : {png("t.png", samples, 16), tiff("t.tif", samples, 16),
                                    jpeg("t.jpg", samples), pgm("t.pgm", samples)}) {
        const std::string good = bytes_of(path);
        for (std::size_t length = 0; length + 3 < good.size(); ++length) {
            const auto mesh = load_model(file(path.substr(path.rfind('/') + 1), good.substr(0, length)), {});
            // Where only what follows the pixels is missing, a picture is whole.
            if (mesh) continue;
            EXPECT_EQ(mesh.error().message.find('\n'), std::string::npos) << mesh.error().message;
        }
        const std::string half =
            refusal(file(path.substr(path.rfind('/') + 1), good.substr(0, good.size() / 2)));
        EXPECT_THAT(half, testing::AnyOf(HasSubstr("a damaged "), HasSubstr("not a picture"))) << path;
    }
    EXPECT_THAT(refusal(file("h.pgm", "P5 60000 60000 255\n")),
                HasSubstr("a picture of 60000 x 60000 pixels; at most"));
    EXPECT_THAT(refusal(file("m.pgm", "P5 9000 9000 255\n")), HasSubstr("its pixels end too early"));
    EXPECT_THAT(refusal(file("x.png", "hello")),
                EndsWith("not a picture that can be read here (PNG, JPEG, TIFF, BMP, PGM)"));
}

}  // namespace
}  // namespace psicarve::flat
