// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/slicer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "hmi/model/load_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/placement.hpp"
#include "shared/base/result.hpp"
#include "tests/hmi/model/mesh_files.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::slice {
namespace {

struct Sliced {
    std::vector<double> heights;
    std::vector<double> angles;
    RadialMap map;

    double radius(std::size_t layer, std::size_t k) const { return map.radius[layer * angles.size() + k]; }
    std::size_t open_cells() const {
        std::size_t sum = 0;
        for (const LayerTotals& layer : map.layers) sum += layer.open_cells;
        return sum;
    }
};

Sliced slice_all(const model::Mesh& mesh, std::size_t layers, std::int64_t points, Placement placement = {}) {
    Sliced out;
    const auto low = placed(placement.up, mesh.facts.min);
    const auto high = placed(placement.up, mesh.facts.max);
    out.heights = layer_heights(low[2], high[2] - low[2], layers);
    out.angles = full_circle_rad(points, 6400, 0.0);
    auto map = radial_map(mesh, placement, out.heights, Directions(out.angles), {});
    EXPECT_TRUE(map.has_value());
    if (map) out.map = std::move(*map);
    return out;
}

TEST(RadialMap, OfABoxIsTheDistanceToItsSides) {
    const Sliced sut = slice_all(shapes::box({-3, -5, 0}, {3, 5, 8}), 7, 201);
    for (std::size_t i = 0; i < sut.map.radius.size(); ++i) {
        const double angle = sut.angles[i % sut.angles.size()];
        const double wanted = std::min(3.0 / std::abs(std::cos(angle)), 5.0 / std::abs(std::sin(angle)));
        ASSERT_NEAR(sut.map.radius[i], wanted, 1e-12) << i;
    }
}

TEST(RadialMap, OfOneDirectionAloneIsThatOfAllRound) {
    const model::Mesh mesh = shapes::box({-3, -5, 0}, {3, 5, 8});
    const std::vector<double> heights{4.0};
    for (const double angle : {0.0, 0.1, 3.0, 6.2}) {
        const std::vector<double> angles{angle};
        const auto sut = radial_map(mesh, {}, heights, Directions(angles), {});
        ASSERT_TRUE(sut);
        EXPECT_NEAR(sut->radius[0], 3.0 / std::abs(std::cos(angle)), 1e-12) << angle;
        EXPECT_EQ(sut->layers[0].walls, 1U) << angle;
    }
}

TEST(RadialMap, OfAPrismIsTheDistanceToItsFacets) {
    constexpr std::size_t kSides = 24;
    const Sliced sut = slice_all(shapes::cylinder(10.0, 0.0, 5.0, kSides), 5, 97);
    const double side = 2.0 * std::numbers::pi / kSides;
    for (std::size_t i = 0; i < sut.map.radius.size(); ++i) {
        const double from_middle = std::fmod(sut.angles[i % sut.angles.size()], side) - side / 2.0;
        ASSERT_NEAR(sut.map.radius[i], 10.0 * std::cos(side / 2.0) / std::cos(from_middle), 2e-6) << i;
    }
}

TEST(RadialMap, OfASphereIsItsSectionsRadius) {
    const Sliced sut = slice_all(shapes::sphere(10.0, 400, 800), 40, 50);
    for (std::size_t layer = 0; layer < sut.heights.size(); ++layer) {
        const double lift = sut.heights[layer] - 10.0;
        for (std::size_t k = 0; k < sut.angles.size(); ++k) {
            ASSERT_NEAR(sut.radius(layer, k), std::sqrt(100.0 - lift * lift), 0.002);
        }
    }
}

TEST(RadialMap, OfATorusIsItsOuterSide) {
    const Sliced sut = slice_all(shapes::torus(12.0, 4.0, 400, 800), 20, 30);
    for (std::size_t layer = 0; layer < sut.heights.size(); ++layer) {
        const double lift = sut.heights[layer] - 4.0;
        ASSERT_NEAR(sut.radius(layer, 7), 12.0 + std::sqrt(16.0 - lift * lift), 0.002);
    }
}

TEST(LayerTotals, OfATorusSayThatNoSectionContainsTheAxis) {
    const Sliced sut = slice_all(shapes::torus(12.0, 4.0, 60, 80), 20, 30);
    for (const LayerTotals& layer : sut.map.layers) {
        EXPECT_TRUE(layer.has_section);
        EXPECT_FALSE(layer.contains_axis);
    }
}

TEST(LayerTotals, OfAClosedBodyHaveNoOpenCells) {
    for (const std::size_t layers : {1U, 7U, 40U, 100U}) {
        EXPECT_EQ(slice_all(shapes::spring(15.0, 4.0, 3.2, 50.0, 150, 24), layers, 90).open_cells(), 0U);
        EXPECT_EQ(slice_all(shapes::figurine(60.0, 40, 64), layers, 90).open_cells(), 0U);
    }
}

TEST(LayerTotals, HaveNoOpenCellsWhereVerticesLieOnDirectionsAndLayers) {
    // Corners at exactly 45 degrees, the middle layer through the waist's vertices.
    const model::Mesh mesh = shapes::grid(2, 8, false, [](std::size_t i, std::size_t j) {
        const double t = shapes::turn_part(j, 8);
        const double r = i == 1 ? 4.0 : 8.0;
        return shapes::Point{r * std::cos(t), r * std::sin(t), static_cast<double>(i)};
    });
    const Sliced sut = slice_all(mesh, 1, 5);
    EXPECT_EQ(sut.open_cells(), 0U);
    for (std::size_t k = 0; k < sut.angles.size(); ++k) EXPECT_NEAR(sut.radius(0, k), 4.0, 1e-6) << k;
}

TEST(LayerTotals, HaveNoOpenCellsWhereTheAxisLiesOnTheSurface) {
    EXPECT_EQ(slice_all(shapes::box({0, 0, 0}, {5, 5, 5}), 5, 90).open_cells(), 0U);
    EXPECT_EQ(slice_all(shapes::box({-5, 0, 0}, {5, 5, 5}), 5, 90).open_cells(), 0U);
}

// sin(2 pi) is not 0: what the first and the last column of such a mesh have in common is not equal bit for
// bit.
TEST(RadialMap, HasNoGapWhereRoundingToreASeam) {
    constexpr std::size_t kColumns = 40;
    const auto at = [](std::size_t row, std::size_t column) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(column) / kColumns;
        return shapes::Point{10.0 * std::cos(turn), 10.0 * std::sin(turn), static_cast<double>(row)};
    };
    shapes::Builder torn;
    for (std::size_t column = 0; column < kColumns; ++column) {
        torn.quad(at(0, column), at(0, column + 1), at(5, column + 1), at(5, column));
        torn.facet({0, 0, 0}, at(0, column + 1), at(0, column));
        torn.facet({0, 0, 5}, at(5, column), at(5, column + 1));
    }
    const mesh_files::Folder folder;
    const auto mesh = model::load_mesh(folder.write("torn.stl", mesh_files::binary_stl(torn.mesh())));
    ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
    const Sliced sut = slice_all(*mesh, 5, 41);
    EXPECT_EQ(sut.open_cells(), 0U);
    for (std::size_t layer = 0; layer < 5; ++layer) EXPECT_NEAR(sut.radius(layer, 0), 10.0, 1e-5) << layer;
}

TEST(LayerTotals, CountOpenCellsWhereAFacetIsMissing) {
    model::Mesh mesh = shapes::cylinder(10.0, 0.0, 5.0, 24);
    mesh.triangles.erase(mesh.triangles.begin() + 10);
    EXPECT_GT(slice_all(mesh, 5, 97).open_cells(), 0U);
}

TEST(LayerTotals, NoteCellsOfAModelTurnedInsideOut) {
    const model::Mesh mesh = shapes::cylinder(10.0, 0.0, 5.0, 24);
    const model::Mesh mirrored = shapes::moved(mesh, [](const shapes::Point& p) {
        return shapes::Point{p[0], -p[1], p[2]};
    });
    EXPECT_EQ(slice_all(mesh, 1, 30).map.layers[0].turned_cells, 0U);
    EXPECT_EQ(slice_all(mirrored, 1, 30).map.layers[0].turned_cells, 58U);
}

TEST(LayerTotals, OfAPipeSayWhichPartIsHidden) {
    const model::Mesh outer = shapes::cylinder(10.0, 0.0, 5.0, 400);
    const model::Mesh inner = shapes::moved(shapes::cylinder(5.0, 0.0, 5.0, 400), [](const shapes::Point& p) {
        return shapes::Point{p[0], -p[1], p[2]};
    });
    const Sliced sut = slice_all(shapes::Builder().add(outer).add(inner).mesh(), 1, 30);
    const LayerTotals& layer = sut.map.layers[0];
    EXPECT_NEAR((layer.radius_sum - layer.outer_sum) / layer.radius_sum, 5.0 / 15.0, 1e-3);
    EXPECT_EQ(layer.hidden_walls, 58U);
    EXPECT_FALSE(layer.contains_axis);
}

TEST(LayerTotals, OfOverlappingSolidsRoundTheAxisSayThatTheyContainIt) {
    const model::Mesh sut = shapes::Builder()
                                .add(shapes::cylinder(10.0, 0.0, 5.0, 40))
                                .add(shapes::box({-3, -3, 0}, {4, 3, 5}))
                                .mesh();
    for (const LayerTotals& layer : slice_all(sut, 3, 30).map.layers) {
        EXPECT_TRUE(layer.contains_axis);
        EXPECT_EQ(layer.open_cells, 0U);
    }
}

TEST(RadialMap, IsSampledAtTheDirectionsAskedForEvenWhenTheyPassAngleZero) {
    const model::Mesh mesh = shapes::box({-3, -5, 0}, {3, 5, 8});
    const std::vector<double> angles = full_circle_rad(40, 6400, 297.3);
    const std::vector<double> heights{1.0};
    const auto sut = radial_map(mesh, {}, heights, Directions(angles), {});
    ASSERT_TRUE(sut.has_value());
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const double wanted =
            std::min(3.0 / std::abs(std::cos(angles[k])), 5.0 / std::abs(std::sin(angles[k])));
        EXPECT_NEAR(sut->radius[k], wanted, 1e-12);
    }
}

TEST(RadialMap, IsZeroWhereNothingIs) {
    const Sliced sut = slice_all(shapes::box({2, 2, 0}, {3, 3, 1}), 1, 91);
    EXPECT_EQ(sut.radius(0, 135), 0.0);
    EXPECT_GT(sut.radius(0, 22), 2.0);
}

TEST(RadialMap, DoesNotDependOnWhereTheModelStandsInTheFile) {
    const model::Mesh here = shapes::figurine(64.0, 30, 40);
    model::Mesh there = here;
    there.origin = {100000.0, -50000.0, 7000.0};
    for (std::size_t k = 0; k < 3; ++k) {
        there.facts.min[k] += there.origin[k];
        there.facts.max[k] += there.origin[k];
    }
    const Sliced a = slice_all(here, 9, 60);
    const Sliced b = slice_all(there, 9, 60, {Up::z, 100000.0, -50000.0});
    for (std::size_t i = 0; i < a.map.radius.size(); ++i) ASSERT_NEAR(a.map.radius[i], b.map.radius[i], 1e-7);
}

TEST(SliceLayers, EndsWhenProgressSaysSo) {
    SliceOptions options;
    options.progress = [](double done) { return done < 0.5; };
    const std::vector<double> heights = layer_heights(0.0, 5.0, 100);
    const std::vector<double> angles = full_circle_rad(20, 6400, 0.0);
    const auto sut =
        radial_map(shapes::cylinder(10.0, 0.0, 5.0, 24), {}, heights, Directions(angles), options);
    ASSERT_FALSE(sut.has_value());
    EXPECT_EQ(sut.error().code, ErrorCode::cancelled);
}

TEST(SliceLayers, ReportsProgressUpToAll) {
    std::vector<double> seen;
    SliceOptions options;
    options.progress = [&seen](double done) {
        seen.push_back(done);
        return true;
    };
    const std::vector<double> heights = layer_heights(0.0, 5.0, 10);
    const std::vector<double> angles = full_circle_rad(20, 6400, 0.0);
    ASSERT_TRUE(radial_map(shapes::cylinder(10.0, 0.0, 5.0, 24), {}, heights, Directions(angles), options));
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_EQ(seen.size(), 10U);
    EXPECT_EQ(seen.back(), 1.0);
}

TEST(FullCircle, StandsAtWholePulsesWithBothHeadsOpposite) {
    const std::vector<double> sut = full_circle_rad(8, 6400, 0.0);
    ASSERT_EQ(sut.size(), 14U);
    for (std::size_t k = 0; k < 7; ++k) {
        const double pulses = sut[k] * 6400.0 / (2.0 * std::numbers::pi);
        EXPECT_NEAR(pulses, std::round(static_cast<double>(k) * 3200.0 / 7.0), 1e-9);
        EXPECT_NEAR(sut[k + 7] - sut[k], std::numbers::pi, 1e-12);
    }
}

}  // namespace
}  // namespace psicarve::slice
