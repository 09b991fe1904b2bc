// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/piece_deviation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "hmi/piece/deviation_picture.hpp"
#include "hmi/piece/job_piece.hpp"
#include "hmi/piece/piece_carver.hpp"
#include "hmi/piece/placed_model.hpp"
#include "hmi/piece/surface_distance.hpp"
#include "hmi/slice/directions.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/fins.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/piece/deviation_rig.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::piece {
namespace {

constexpr std::size_t kRows = 40;
constexpr std::size_t kColumns = 180;

StockMap blank() {
    return StockMap(10.0, 0.0, 0.25, kRows, kColumns);
}

std::vector<std::size_t> all_rows() {
    std::vector<std::size_t> rows(kRows);
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    return rows;
}

/// The least distance of a place from points strewn over all triangles between the cells of a map.
double strewn_distance(const StockMap& stock, const std::vector<float>& radii, std::size_t row,
                       std::size_t column, double radius_mm) {
    const auto point = [&](std::size_t r, std::size_t c) {
        const double radius = radii[r * kColumns + c % kColumns];
        const double at = stock.direction_rad(c % kColumns);
        return std::array<double, 3>{radius * std::cos(at), radius * std::sin(at), stock.height_mm(r)};
    };
    const double at = stock.direction_rad(column);
    const std::array<double, 3> from{radius_mm * std::cos(at), radius_mm * std::sin(at),
                                     stock.height_mm(row)};
    constexpr int kSteps = 30;
    double best2 = std::numeric_limits<double>::max();
    for (std::size_t r = row < 8 ? 0 : row - 8; r < std::min(kRows - 1, row + 8); ++r) {
        for (std::size_t c = column + kColumns - 8; c < column + kColumns + 8; ++c) {
            const auto a = point(r, c);
            const auto high = point(r + 1, c + 1);
            for (const auto& b : {point(r, c + 1), point(r + 1, c)}) {
                for (int i = 0; i <= kSteps; ++i) {
                    for (int j = 0; i + j <= kSteps; ++j) {
                        double sum2 = 0.0;
                        for (std::size_t k = 0; k < 3; ++k) {
                            const double place =
                                a[k] + (b[k] - a[k]) * i / kSteps + (high[k] - a[k]) * j / kSteps;
                            sum2 += (place - from[k]) * (place - from[k]);
                        }
                        best2 = std::min(best2, sum2);
                    }
                }
            }
        }
    }
    return std::sqrt(best2);
}

TEST(SurfaceDistance, IsTheShortestWayToTheTrianglesBetweenCells) {
    const StockMap stock = blank();
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<float> radii(kRows * kColumns);
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double step = (i % kColumns) / 15 % 2 == 0 ? 0.0 : 1.2;
        radii[i] = static_cast<float>(7.0 + step + 0.2 * part(random));
    }
    const SurfaceDistance sut(stock, radii);
    for (int round = 0; round < 20; ++round) {
        const auto row = static_cast<std::size_t>(part(random) * kRows);
        const auto column = static_cast<std::size_t>(part(random) * kColumns);
        const double radius_mm = 6.5 + 2.5 * part(random);
        const double wanted = strewn_distance(stock, radii, row, column, radius_mm);
        ASSERT_LE(sut.of(row, column, radius_mm), wanted + 1e-5) << row << ' ' << column;
        ASSERT_NEAR(sut.of(row, column, radius_mm), wanted, 0.02) << row << ' ' << column << ' ' << radius_mm;
    }
}

TEST(PieceDeviation, OfThePieceThatIsTheModelIsNothing) {
    const StockMap piece = blank();
    const std::vector<float> wanted(kRows * kColumns, 10.0F);
    const PieceDeviation sut = deviation_of(piece, wanted, all_rows());
    EXPECT_EQ(sut.gouge.max_mm, 0.0);
    EXPECT_EQ(sut.leftover.max_mm, 0.0);
    EXPECT_EQ(sut.place_count, kRows * kColumns);
    EXPECT_EQ(sut.histogram[5], kRows * kColumns);
}

TEST(PieceDeviation, TellsAGougeAndWhatIsLeftWithTheirPlaces) {
    StockMap piece = blank();
    for (std::size_t row = 0; row < kRows; ++row)
        std::fill(piece.row(row).begin(), piece.row(row).end(), 8.0F);
    piece.row(10)[45] = 7.5F;
    piece.row(30)[90] = 8.2F;
    piece.row(31)[90] = 8.2F;
    const std::vector<float> wanted(kRows * kColumns, 8.0F);
    const PieceDeviation sut = deviation_of(piece, wanted, all_rows());
    EXPECT_NEAR(sut.gouge.max_mm, 0.5, 2e-3);
    EXPECT_NEAR(sut.gouge.direction_deg, 90.0, 1e-9);
    EXPECT_NEAR(sut.gouge.height_mm, 2.625, 1e-9);
    EXPECT_NEAR(sut.gouge.mean_mm, 0.5 / (kRows * kColumns), 1e-6);
    EXPECT_NEAR(sut.leftover.max_mm, 0.2, 2e-3);
    EXPECT_NEAR(sut.leftover.direction_deg, 180.0, 1e-9);
    EXPECT_EQ(sut.histogram[1], 1U);
    EXPECT_EQ(sut.histogram[8], 2U);
}

// Along the radius it would be 2 mm.
TEST(PieceDeviation, BesideASteepWallIsTheWayToTheWall) {
    StockMap piece = blank();
    std::vector<float> wanted(kRows * kColumns, 8.0F);
    for (std::size_t row = 0; row < kRows; ++row) {
        std::fill(piece.row(row).begin(), piece.row(row).end(), 8.0F);
        for (std::size_t column = 0; column < 60; ++column) {
            wanted[row * kColumns + column] = 6.0F;
            piece.row(row)[column] = column == 0 ? 8.0F : 6.0F;
        }
    }
    const PieceDeviation sut = deviation_of(piece, wanted, all_rows());
    EXPECT_EQ(sut.gouge.max_mm, 0.0);
    EXPECT_GT(sut.leftover.max_mm, 0.05);
    EXPECT_LT(sut.leftover.max_mm, 8.0 * 2.0 * kPi / kColumns);
}

TEST(PieceDeviation, IsOneJsonObjectWhoseSharesSumUp) {
    StockMap piece = blank();
    piece.row(3)[7] = 9.0F;
    const PieceDeviation sut = deviation_of(piece, std::vector<float>(kRows * kColumns, 10.0F), all_rows());
    const auto json = nlohmann::json::parse(deviation_json(sut));
    double sum = 0.0;
    for (const auto& bin : json["histogram"]) sum += bin["share"].get<double>();
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_TRUE(json["histogram"].front()["from_mm"].is_null());
    EXPECT_TRUE(json["histogram"].back()["to_mm"].is_null());
    EXPECT_NEAR(json["gouge"]["max_mm"].get<double>(), sut.gouge.max_mm, 1e-12);
    EXPECT_EQ(json["places"], kRows * kColumns);
    EXPECT_NE(deviation_text(sut).find("gouge at most"), std::string::npos);
    EXPECT_TRUE(deviation_png(sut, "a.stl"));
    EXPECT_TRUE(deviation_png(deviation_of(piece, std::vector<float>(kRows * kColumns, 10.0F), {}), ""));
}

TEST(PieceDeviation, OfAPointToolIsARoundingOfItsPulses) {
    const PieceDeviation sut = carved(shapes::cylinder(9.0, 0.0, 8.0, 720), Profile{}, 12, 361);
    EXPECT_EQ(sut.place_count, 12U * 720U);
    EXPECT_LE(sut.gouge.max_mm, 0.0025);
    EXPECT_LE(sut.leftover.max_mm, 0.0025);
}

// Y steps a little before or after its even share; where that is the boundary of two rows each belongs to
// one.
TEST(PieceDeviation, ASpiralsPointLeavesNoRowOutWhereverYsStepsFall) {
    Profile profile;
    profile.blank.radius_mm = 12.0;
    auto options = cam::small(9, 61);
    options.joining = Joining::spiral;
    const std::vector<std::byte> blob =
        job_blob_from_table(cam::built(shapes::cylinder(9.0, 0.0, 8.0, 90), profile, options).table);
    const auto job = JobView::check(blob);
    ASSERT_TRUE(job);
    const auto geometry = verify::JobGeometry::make(*job, profile);
    ASSERT_TRUE(geometry);
    StockMap stock = blank_of(*geometry, profile, 720);
    PieceCarver carver(*geometry, profile, stock);
    std::mt19937_64 random(11);
    for (std::uint32_t layer = 0; layer < geometry->layer_count(); ++layer) {
        for (std::uint32_t step = 0; step + 1 < geometry->point_count(); ++step) {
            const verify::Positions from = geometry->target(layer, step);
            const verify::Positions to = geometry->target(layer, step + 1);
            const std::int64_t turn =
                std::max<std::int64_t>(1, std::abs(to[index_of(Axis::psi)] - from[index_of(Axis::psi)]));
            for (std::int64_t k = 0; k <= turn; ++k) {
                verify::Positions at{};
                for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
                    const double part = static_cast<double>(k) / static_cast<double>(turn);
                    at[axis] = from[axis] + std::llround(part * static_cast<double>(to[axis] - from[axis]));
                }
                at[index_of(Axis::y)] += static_cast<std::int64_t>(random() % 3) - 1;
                carver.settle(at, true);
            }
        }
    }
    carver.finish();
    for (const std::size_t row : carved_rows(*geometry, stock, true)) {
        for (std::size_t column = 0; column < stock.column_count(); ++column)
            ASSERT_LT(stock.row(row)[column], stock.surface_mm(column) - 0.1F) << row << ' ' << column;
    }
}

TEST(PieceDeviation, APointBetweenTwoRowsCutsTheRidgesOfBoth) {
    const model::Mesh mesh = shapes::box({-6, -6, 0}, {6, 6, 8});
    const Profile profile;
    const std::vector<std::byte> blob =
        job_blob_from_table(cam::built(mesh, profile, cam::small(9, 61)).table);
    const auto job = JobView::check(blob);
    ASSERT_TRUE(job);
    const auto geometry = verify::JobGeometry::make(*job, profile);
    const auto placed = place_as_sliced(std::make_shared<const model::Mesh>(mesh), *job, profile);
    ASSERT_TRUE(geometry && placed);
    // So few columns that the box's edges stand out between them.
    const StockMap stock = blank_of(*geometry, profile, 45);
    const auto wanted_mm = wanted_radii(*placed, stock, {1, {}});
    ASSERT_TRUE(wanted_mm);
    const auto rows = carved_rows(*geometry, stock, true);
    const auto make = [&] {
        return Ridges(*placed, tool::tool_of(profile.tool, 1.0), stock, *wanted_mm, rows, *geometry);
    };
    const auto missing_after = [&](double off_pulses) {
        Ridges sut = make();
        std::size_t index = 0;
        while (index < sut.all().size() && sut.all()[index].row < 4) ++index;
        if (index == sut.all().size()) return -1.0;
        const Ridge& ridge = sut.all()[index];
        const double boundary_mm = stock.height_mm(ridge.row) - 0.5 * stock.row_mm();
        for (int k = -4; k <= 4; ++k) {
            sut.cut(ridge.direction_rad + k * geometry->rad_per_pulse(),
                    boundary_mm + off_pulses / geometry->y_pulses_per_mm(), 3.0);
        }
        return sut.missing_mm(index);
    };
    EXPECT_GT(missing_after(1.0), 0.1);
    EXPECT_GT(missing_after(-1.0), 0.1);
    EXPECT_EQ(missing_after(-3.0), 0.0);
}

TEST(PieceDeviation, OfABallThatCannotReachACornerIsWhatItLeavesThere) {
    // Two prisms, one on the other: in the inner corner a ball's surface stays R (1 - 1 / sqrt 2) away from
    // both.
    const model::Mesh mesh = shapes::Builder()
                                 .add(shapes::cylinder(12.0, 0.0, 4.0, 720))
                                 .add(shapes::cylinder(8.0, 4.0, 8.0, 720))
                                 .mesh();
    Profile profile;
    profile.tool.shape = ToolShape::ball;
    profile.tool.diameter_mm = 3.0;
    profile.psi.pulses_per_rev = 1440;
    const PieceDeviation sut = carved(mesh, profile, 80, 361);
    EXPECT_LE(sut.gouge.max_mm, 0.01);
    EXPECT_NEAR(sut.leftover.max_mm, 1.5 * (1.0 - std::sqrt(0.5)), 0.04);
}

// The tables' directions are 6 degrees apart, and none of them meets the needle.
TEST(PieceDeviation, TellsOfANeedleThatWasCutOff) {
    for (const double direction_deg : {3.0, 200.7}) {
        if (!psicarve::test::is_thorough() && direction_deg != 3.0) continue;
        for (const double width_deg : {0.1, 1.2}) {
            const model::Mesh mesh = shapes::needle(direction_deg, width_deg);
            for (const Profile& profile :
                 {with_tool(ToolShape::ball, 0.5, 0.0), with_tool(ToolShape::point, 1.0, 60.0)}) {
                SCOPED_TRACE(testing::Message()
                             << direction_deg << ' ' << width_deg << ' ' << name_of(profile.tool.shape));
                const PieceDeviation sut = carved(mesh, profile, 4, 31);
                EXPECT_NEAR(sut.gouge.max_mm, 5.0, 0.03);
                EXPECT_NEAR(sut.gouge.direction_deg, direction_deg, 0.6 * width_deg + 0.3);
                EXPECT_GT(sut.histogram.front(), 0U);
            }
        }
    }
}

// Two corners of an outline one pulse apart: between the table's directions the straight way cuts its end.
TEST(PieceDeviation, TellsHowMuchOfAFinIsCutOffWhereverItStandsBetweenPoints) {
    const Profile profile = with_tool(ToolShape::vee, 3.0, 20.0);
    const auto round = slice::full_circle_rad(200, profile.psi.pulses_per_rev, 0.0);
    for (const std::size_t k : {4U, 8U, 9U}) {
        const double direction_deg = deg_from_rad(0.5 * (round[k] + round[k + 1]));
        const PieceDeviation sut = carved(shapes::finned(direction_deg, 1.2, 0.1), profile, 40, 200);
        // The tip passes 0.79 mm deep; the expected piece is cut twice a column, which leaves cusps.
        EXPECT_GT(sut.gouge.max_mm, 0.55) << k;
        EXPECT_LT(sut.gouge.max_mm, 0.82) << k;
    }
}

TEST(PieceDeviation, OfAFinThatIsKeptIsLittle) {
    for (const double end_deg : {0.1, 0.4, 2.0}) {
        const model::Mesh mesh = shapes::finned(90.0, end_deg + 1.1, end_deg);
        EXPECT_LT(carved(mesh, with_tool(ToolShape::ball, 0.5, 0.0), 40, 1601).gouge.max_mm, 0.05) << end_deg;
        EXPECT_LT(carved(mesh, with_tool(ToolShape::vee, 3.0, 20.0), 40, 1601).gouge.max_mm, 0.05) << end_deg;
    }
}

// What a roof hides is none of the heads' work: the ring stands 6 mm out over the column's foot.
TEST(PieceDeviation, DoesNotTellOfWhatIsHidden) {
    const model::Mesh mesh = shapes::Builder()
                                 .add(shapes::cylinder(9.0, 0.0, 4.0, 90))
                                 .add(shapes::cylinder(15.0, 4.0, 8.0, 90))
                                 .add(shapes::moved(shapes::sphere(3.0, 24, 24),
                                                    [](const shapes::Point& p) {
                                                        return shapes::Point{p[0] + 6.0, p[1], p[2] + 2.0};
                                                    }))
                                 .mesh();
    EXPECT_LT(carved(mesh, with_tool(ToolShape::ball, 1.0, 0.0), 40, 721).gouge.max_mm, 0.02);
}

TEST(PieceDeviation, OfATurnedBoxIsNoMoreForItsCornersBetweenCells) {
    const model::Mesh mesh = shapes::moved(shapes::box({-8, -5, 0}, {9, 7, 8}), [](const shapes::Point& p) {
        const double turn = 0.3;
        return shapes::Point{p[0] * std::cos(turn) - p[1] * std::sin(turn),
                             p[0] * std::sin(turn) + p[1] * std::cos(turn), p[2]};
    });
    EXPECT_LT(carved(mesh, with_tool(ToolShape::ball, 2.0, 0.0), 40, 1601).gouge.max_mm, 0.02);
}

TEST(PieceDeviation, IsRefusedForAnotherModel) {
    const auto built = cam::built(cam::oblong(), Profile{}, cam::small(4, 9));
    const std::vector<std::byte> blob = job_blob_from_table(built.table);
    const auto job = JobView::check(blob);
    auto other = std::make_shared<model::Mesh>(cam::oblong());
    other->source_hash = 5;
    const auto sut = place_as_sliced(other, *job, Profile{});
    ASSERT_FALSE(sut);
    EXPECT_EQ(sut.error().code, ErrorCode::bad_input);
    EXPECT_NE(sut.error().message.find("is not the file"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::piece
