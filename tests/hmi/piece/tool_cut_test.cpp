// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/tool_cut.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "shared/base/units.hpp"

namespace psicarve::piece {
namespace {

using tool::Shape;
using tool::Tool;

constexpr Tool kBall{Shape::ball, 1.5, 0.0};
constexpr Tool kFlat{Shape::flat, 1.0, 0.0};
constexpr Tool kVee{Shape::vee, 3.0, 60.0};

/// Where a ray from the axis enters the tool, by walking along it; nothing when it does not, or when it
/// leaves the tool again before `radius_mm`.
std::optional<double> entry_mm(const Tool& tool, double across_rad, double up_mm, double tip_mm,
                               double radius_mm) {
    constexpr double kStep_mm = 2e-3;
    if (std::abs(up_mm) > tool.radius) return {};
    const double sine = std::sin(across_rad);
    const double cosine = std::cos(across_rad);
    std::optional<double> first;
    for (double at_mm = tip_mm; at_mm <= radius_mm; at_mm += kStep_mm) {
        const double s = std::sqrt(at_mm * at_mm * sine * sine + up_mm * up_mm);
        const bool is_in = s <= tool.radius && at_mm * cosine >= tip_mm + tool::rise(tool, s);
        if (is_in && !first) first = at_mm;
        if (first && !is_in) return {};
    }
    return first;
}

class Shapes : public ::testing::TestWithParam<Tool> {};

TEST_P(Shapes, CutWhereARayEntersThem) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    int cut_cells = 0;
    for (int round = 0; round < 60; ++round) {
        StockMap stock(12.0, 0.0, 0.25, 32, 180);
        ToolCut sut(GetParam(), stock);
        const double direction_rad = 2.0 * kPi * part(random);
        const double height_mm = 8.0 * part(random);
        const double tip_mm = 3.0 + 7.0 * part(random);
        sut.at(direction_rad, height_mm, tip_mm);
        for (std::size_t row = 0; row < stock.row_count(); ++row) {
            for (std::size_t column = 0; column < stock.column_count(); ++column) {
                const double across_rad =
                    std::remainder(stock.direction_rad(column) - direction_rad, 2.0 * kPi);
                if (std::abs(across_rad) > 1.4) continue;
                // Where the blank's surface meets the tool's side a step of the walk decides.
                const double side_mm =
                    std::hypot(12.0 * std::sin(across_rad), stock.height_mm(row) - height_mm);
                if (std::abs(side_mm - GetParam().radius) < 5e-3) continue;
                const auto wanted =
                    entry_mm(GetParam(), across_rad, stock.height_mm(row) - height_mm, tip_mm, 12.0);
                const double radius_mm = stock.row(row)[column];
                if (wanted) ++cut_cells;
                ASSERT_NEAR(radius_mm, wanted.value_or(12.0), 1e-2) << row << ' ' << column;
            }
        }
        EXPECT_GT(sut.contacts(), 0U);
    }
    EXPECT_GT(cut_cells, 100);
}

INSTANTIATE_TEST_SUITE_P(Tools, Shapes, ::testing::Values(kBall, kFlat, kVee), [](const auto& named) {
    return named.param.shape == Shape::ball ? "ball" : named.param.shape == Shape::flat ? "flat" : "vee";
});

TEST(ToolCut, TurnedOnceRoundABallLeavesItsOwnGroove) {
    StockMap stock(10.0, 0.0, 0.1, 100, 720);
    ToolCut sut(kBall, stock);
    for (int step = 0; step < 6400; ++step) sut.at(step * 2.0 * kPi / 6400.0, 5.0, 8.0);
    for (std::size_t row = 0; row < stock.row_count(); ++row) {
        const double up = stock.height_mm(row) - 5.0;
        const double wanted =
            std::abs(up) > 1.5 ? 10.0 : std::min(10.0, 8.0 + tool::rise(kBall, std::abs(up)));
        for (const float radius : stock.row(row)) ASSERT_NEAR(radius, wanted, 1e-4) << row;
    }
    double removed = 0.0;
    for (std::size_t row = 0; row < stock.row_count(); ++row)
        removed += kPi * (100.0 - stock.row(row)[0] * stock.row(row)[0]) * 0.1;
    EXPECT_NEAR(stock.removed_mm3(), removed, 1e-2);
}

TEST(ToolCut, NeverGivesMaterialBack) {
    StockMap stock(10.0, 0.0, 0.2, 20, 360);
    ToolCut sut(kFlat, stock);
    sut.at(1.0, 2.0, 5.0);
    const std::vector<float> before(stock.row(10).begin(), stock.row(10).end());
    sut.at(1.0, 2.0, 9.0);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), stock.row(10).begin()));
}

TEST(ToolCut, WhatIsOutsideOfTheBlanksHeightIsLeftAlone) {
    StockMap stock(10.0, 5.0, 0.2, 20, 360);
    ToolCut sut(kBall, stock);
    sut.at(1.0, 3.0, 5.0);
    sut.at(1.0, 11.0, 5.0);
    EXPECT_EQ(stock.removed_mm3(), 0.0);
}

TEST(ToolCut, APointIsAsNarrowAsACell) {
    StockMap stock(10.0, 0.0, 0.2, 20, 360);
    ToolCut sut({Shape::point, 0.0, 0.0}, stock);
    sut.at(stock.direction_rad(7), stock.height_mm(3), 4.0);
    EXPECT_FLOAT_EQ(stock.row(3)[7], 4.0F);
    EXPECT_FLOAT_EQ(stock.row(3)[9], 10.0F);
    EXPECT_FLOAT_EQ(stock.row(5)[7], 10.0F);
}

TEST(ToolCut, APointOnTheBoundaryOfTwoRowsCutsBoth) {
    StockMap stock(10.0, 0.0, 0.2, 20, 360);
    ToolCut sut({Shape::point, 0.0, 0.0}, stock, 7.0, 0.01);
    const double boundary_mm = stock.height_mm(3) + 0.1;
    const auto expect_cut = [&](std::size_t column, double height_mm, bool lower, bool upper) {
        sut.at(stock.direction_rad(column), height_mm, 4.0);
        EXPECT_EQ(stock.row(3)[column] < 10.0F, lower) << height_mm;
        EXPECT_EQ(stock.row(4)[column] < 10.0F, upper) << height_mm;
        EXPECT_FLOAT_EQ(stock.row(2)[column], 10.0F);
        EXPECT_FLOAT_EQ(stock.row(5)[column], 10.0F);
    };
    expect_cut(1, boundary_mm - 0.009, true, true);
    expect_cut(2, boundary_mm + 0.009, true, true);
    expect_cut(3, boundary_mm - 0.011, true, false);
    expect_cut(4, boundary_mm + 0.011, false, true);
    // The lowest and the highest row have one neighbour.
    sut.at(stock.direction_rad(5), 0.0, 4.0);
    EXPECT_LT(stock.row(0)[5], 10.0F);
    sut.at(stock.direction_rad(5), 4.0, 4.0);
    EXPECT_LT(stock.row(19)[5], 10.0F);
}

TEST(ToolCut, APointInTheMiddleOfALowRowCutsThatAlone) {
    StockMap stock(10.0, 0.0, 0.02, 20, 360);
    ToolCut sut({Shape::point, 0.0, 0.0}, stock, 7.0, 0.02);
    sut.at(stock.direction_rad(7), stock.height_mm(3), 4.0);
    EXPECT_FLOAT_EQ(stock.row(2)[7], 10.0F);
    EXPECT_FLOAT_EQ(stock.row(3)[7], 4.0F);
    EXPECT_FLOAT_EQ(stock.row(4)[7], 10.0F);
}

}  // namespace
}  // namespace psicarve::piece
