// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "hmi/picture/canvas.hpp"
#include "hmi/picture/deviation_map.hpp"
#include "hmi/picture/picture.hpp"
#include "hmi/picture/piece_grid.hpp"
#include "hmi/picture/piece_view.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::verify {
namespace {

/// A surface as the job wants it, without a trace: for drawing alone.
CarvedSurface surface_of(const SampleJob& job) {
    const auto geometry = JobGeometry::make(job.view(), job.profile);
    CarvedSurface surface(*geometry);
    for (std::uint32_t layer = 0; layer < surface.layer_count(); ++layer) {
        for (std::uint32_t d = 0; d < surface.direction_count(); ++d) {
            surface.touch(layer, d,
                          static_cast<float>(*geometry->wanted_mm(layer, geometry->direction_of(d))));
            surface.note_deviation(layer, d, 0);
        }
    }
    return surface;
}

struct DecodedPng {
    unsigned width = 0;
    unsigned height = 0;
    std::vector<png_byte> rgb;
};
DecodedPng decode(const std::vector<std::byte>& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0) << image.message;
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0) << image.message;
    return {image.width, image.height, std::move(pixels)};
}

/// A body round but for a nose towards one direction.
SampleJob nosed_job(double nose_deg) {
    return {Profile{}, 60, 181, Joining::continuous, [nose_deg](double angle, double layer) {
                const double off = std::remainder(angle - rad_from_deg(nose_deg), 2.0 * kPi);
                return 6.0 + (std::abs(off) < 0.2 && layer > 20 && layer < 40 ? 3.0 : 0.0);
            }};
}

struct Extent {
    std::size_t left;
    std::size_t right;
};
Extent extent_of(const PixelImage& image) {
    Extent extent{image.width, 0};
    for (std::size_t n = 0; n < image.argb.size(); ++n) {
        if (image.argb[n] >> 24U == 0) continue;
        extent.left = std::min(extent.left, n % image.width);
        extent.right = std::max(extent.right, n % image.width);
    }
    return extent;
}

TEST(Picture, IsAPngEightHundredPixelsWide) {
    const SampleJob job = wavy_job(Joining::continuous, 40, 101);
    const auto png = picture_png(surface_of(job), caption_of(job.view(), VerifyReport{}));
    ASSERT_TRUE(png);
    EXPECT_EQ(decode(*png).width, 800U);
}

TEST(Picture, OfFewLayersAndOfManyCanBeDrawn) {
    for (const std::uint32_t layers : {1U, 2U, 10U, test::is_thorough() ? 3000U : 400U}) {
        const SampleJob job(Profile{}, layers, 2 + layers / 2, Joining::continuous,
                            [](double, double) { return 5.0; });
        const auto png = picture_png(surface_of(job), caption_of(job.view(), VerifyReport{}));
        ASSERT_TRUE(png) << layers;
        EXPECT_EQ(decode(*png).width, 800U);
    }
}

TEST(Picture, ThatCannotBeWrittenLeavesNothing) {
    const SampleJob job = wavy_job();
    const std::string folder = testing::TempDir() + "psicarve_picture_" + std::to_string(::getpid());
    ASSERT_TRUE(std::filesystem::create_directory(folder));
    EXPECT_FALSE(write_picture(folder + "/none/x.png", surface_of(job), {}));
    EXPECT_TRUE(write_picture(folder + "/x.png", surface_of(job), {}));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
    std::filesystem::remove_all(folder);
}

TEST(Picture, ShowsTheRightSideOnTheRight) {
    // Looked at from direction 0, direction 90 is on the viewer's right: counter-clockwise seen from above.
    const PieceGrid grid = make_piece_grid(surface_of(nosed_job(90.0)));
    const PixelImage image = draw_piece(
        grid,
        {.azimuth_rad = 0.0, .elevation_rad = 0.3, .px_per_mm = 5.0, .width_px = 120, .height_px = 120});
    const Extent extent = extent_of(image);
    EXPECT_NEAR(60.0 - static_cast<double>(extent.left), 30.0, 2.0);
    EXPECT_NEAR(static_cast<double>(extent.right) - 60.0, 45.0, 2.0);
}

TEST(Picture, FitsThePieceIntoItsFrame) {
    const PieceGrid grid = make_piece_grid(surface_of(nosed_job(90.0)));
    const double px_per_mm = fitting_px_per_mm(grid, 0.3, 120.0, 120.0);
    const PixelImage image = draw_piece(grid, {.azimuth_rad = 1.0,
                                               .elevation_rad = 0.3,
                                               .px_per_mm = px_per_mm,
                                               .width_px = 120,
                                               .height_px = 120});
    for (std::size_t n = 0; n < 120; ++n) {
        EXPECT_EQ(image.argb[n] >> 24U, 0U);
        EXPECT_EQ(image.argb[119 * 120 + n] >> 24U, 0U);
        EXPECT_EQ(image.argb[n * 120] >> 24U, 0U);
        EXPECT_EQ(image.argb[n * 120 + 119] >> 24U, 0U);
    }
}

TEST(DeviationMap, ShowsASingleStrayCellOfManyInItsColour) {
    const SampleJob job(Profile{}, 500, 501, Joining::continuous, [](double, double) { return 5.0; });
    CarvedSurface surface = surface_of(job);
    surface.note_deviation(250, 500, -9);
    const PixelImage map = draw_deviation_map(surface, DeviationScale(9), 100, 100);
    std::size_t blue = 0;
    for (const std::uint32_t pixel : map.argb) blue += (pixel & 0xFFU) > (pixel >> 16U & 0xFFU) + 40U ? 1 : 0;
    EXPECT_EQ(blue, 1U);
    EXPECT_GT(map.argb[49 * 100 + 50] & 0xFFU, (map.argb[49 * 100 + 50] >> 16U & 0xFFU) + 40U);
}

TEST(DeviationMap, OfACarvingThatWasCutShortLeavesTheRestWithoutColour) {
    const SampleJob job = wavy_job(Joining::continuous, 4, 21);
    const auto geometry = JobGeometry::make(job.view(), job.profile);
    CarvedSurface surface(*geometry);
    for (std::uint32_t d = 0; d < surface.direction_count(); ++d) surface.note_deviation(0, d, 0);
    surface.note_passed(1, 0, 50);
    const auto is_red = [](std::uint32_t pixel) { return (pixel >> 16U & 0xFFU) > (pixel & 0xFFU) + 40U; };
    const auto is_pale = [](std::uint32_t pixel) {
        return (pixel >> 16U & 0xFFU) > 200U && !((pixel & 0xFFU) < 180U);
    };
    const PixelImage whole = draw_deviation_map(surface, DeviationScale(1), 40, 4);
    const PixelImage carved = draw_deviation_map(surface, DeviationScale(1), 40, 4, MapShows::carved);
    EXPECT_GT(std::count_if(whole.argb.begin(), whole.argb.end(), is_red), 100);
    EXPECT_EQ(std::count_if(carved.argb.begin(), carved.argb.end(), is_red), 0);
    EXPECT_EQ(std::count_if(carved.argb.begin(), carved.argb.end(), is_pale), 40);
    // Of one colour, without relief, and darker than what is carved anywhere.
    EXPECT_EQ(std::count(carved.argb.begin(), carved.argb.end(), carved.argb.front()), 120);
    EXPECT_LT(carved.argb.front() & 0xFFU, 130U);
}

// Layers 1 and 2 of four, a point missed in the upper one; a tip came by the uppermost on its way out.
TEST(DeviationMap, OfSomeLayersLeavesTheOthersWithoutColour) {
    const SampleJob job = wavy_job(Joining::continuous, 4, 21);
    const auto geometry = JobGeometry::make(job.view(), job.profile, {1, 2});
    ASSERT_TRUE(geometry);
    CarvedSurface surface(*geometry);
    for (std::uint32_t layer = 1; layer < 3; ++layer) {
        for (std::uint32_t d = 0; d < surface.direction_count(); ++d) {
            if (layer == 1 || d != 7) surface.note_deviation(layer, d, 0);
        }
    }
    surface.touch(3, 5, 7.0F);
    EXPECT_FALSE(surface.is_carved(3, 5));
    const PixelImage map = draw_deviation_map(surface, DeviationScale(surface.max_deviation_pulses()), 40, 4,
                                              MapShows::asked_for);
    const std::uint32_t grey = map.argb.front();
    EXPECT_LT(grey & 0xFFU, 130U);
    for (std::size_t x = 0; x < 40; ++x) {
        EXPECT_EQ(map.argb[x], grey) << x;
        EXPECT_EQ(map.argb[120 + x], grey) << x;
        EXPECT_NE(map.argb[40 + x], grey) << x;
        EXPECT_NE(map.argb[80 + x], grey) << x;
        const bool is_red = (map.argb[40 + x] >> 16U & 0xFFU) > (map.argb[40 + x] & 0xFFU) + 40U;
        EXPECT_EQ(is_red, x == 7) << "missed, " << x;
    }
}

TEST(Picture, HasTheOtherLayersWithoutColourWhereSomeWereAskedFor) {
    const SampleJob job = wavy_job(Joining::continuous, 4, 21);
    PerfectMachine machine(job);
    machine.approach(1).layer(1).link_to(2).layer(2).finish();
    auto sut = Verifier::make(job.view(), job.profile, {1, 2});
    ASSERT_TRUE(sut);
    ASSERT_TRUE(sut->begin(machine.start));
    sut->feed(machine.events);
    const VerifyReport report = sut->finish();
    ASSERT_TRUE(report.ok) << report_text(report);
    PictureCaption caption = caption_of(job.view(), report);
    EXPECT_TRUE(caption.is_of_part);
    EXPECT_FALSE(caption.is_of_carved_alone);
    EXPECT_EQ(verdict_of(caption), "verified on the pins");
    const auto part = picture_png(sut->surface(), caption);
    caption.is_of_part = false;
    const auto whole = picture_png(sut->surface(), caption);
    ASSERT_TRUE(part && whole);
    const auto colour = [](const std::vector<std::byte>& png, unsigned x, unsigned y) {
        const DecodedPng decoded = decode(png);
        const png_byte* const at = decoded.rgb.data() + 3 * (std::size_t{y} * decoded.width + x);
        return std::array<int, 3>{at[0], at[1], at[2]};
    };
    constexpr std::array<int, 3> kGrey{107, 112, 122};  // kUncarvedColour
    for (const unsigned y : {110U, 450U}) {
        EXPECT_EQ(colour(*part, 600, y), kGrey) << y;
        EXPECT_GT(colour(*whole, 600, y)[0], colour(*whole, 600, y)[2] + 40) << "left on";
    }
    EXPECT_GT(colour(*part, 600, 280)[2], 180) << "as wanted";
    EXPECT_EQ(colour(*part, 718, 478), kGrey) << "the key";
    EXPECT_NE(colour(*whole, 718, 478), kGrey);
}

TEST(Picture, OfADryRunSaysThatItIsOne) {
    const SampleJob job = wavy_job();
    VerifyReport report;
    report.ok = true;
    EXPECT_EQ(verdict_of(caption_of(job.view(), report)), "verified on the pins");
    report.is_dry = true;
    EXPECT_EQ(verdict_of(caption_of(job.view(), report)), "dry run, verified on the pins");
    report.ok = false;
    EXPECT_EQ(verdict_of(caption_of(job.view(), report)), "NOT verified");
    report = {};
    report.ok = true;
    report.is_cut = true;
    EXPECT_EQ(verdict_of(caption_of(job.view(), report)), "verified as far as it went");
}

TEST(Canvas, TakesAnyBytesForText) {
    EXPECT_EQ(as_utf8("a\xC3\xA4\xE6\x9C\xA8z"), "a\xC3\xA4\xE6\x9C\xA8z");
    EXPECT_EQ(as_utf8("a\xC3z\xFF\xED\xA0\x80\x01"), "a?z?????");
    Canvas sut(100, 40, {1.0, 1.0, 1.0});
    sut.text(2.0, 20.0, std::string(500, '\xC3') + "\xE6\x9C\xA8", {12.0, false, {}}, Canvas::Align::left,
             80.0);
    EXPECT_TRUE(sut.png());
}

}  // namespace
}  // namespace psicarve::verify
