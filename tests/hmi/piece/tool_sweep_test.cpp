// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/tool_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "shared/base/units.hpp"
#include "tests/parameter_name.hpp"

namespace psicarve::piece {
namespace {

using tool::Shape;
using tool::Tool;

struct Work {
    Tool tool;
    std::size_t columns;
    double offset_mm;  ///< of the blank from the axis
};

std::string tool_name(const Tool& tool) {
    switch (tool.shape) {
        case Shape::point:
            return "point";
        case Shape::ball:
            return "ball";
        case Shape::flat:
            return "flat";
        case Shape::vee:
            return "vee";
    }
    return "tool";
}

void expect_same_bits(const StockMap& a, const StockMap& b) {
    for (std::size_t row = 0; row < a.row_count(); ++row) {
        for (std::size_t column = 0; column < a.column_count(); ++column) {
            ASSERT_EQ(std::bit_cast<std::uint32_t>(a.row(row)[column]),
                      std::bit_cast<std::uint32_t>(b.row(row)[column]))
                << row << ' ' << column << ": " << a.row(row)[column] << ' ' << b.row(row)[column];
        }
    }
}

StockMap blank_for(const Work& work) {
    StockMap stock(12.0, 0.0, 0.25, 40, work.columns);
    if (work.offset_mm > 0.0) {
        BlankProfile blank;
        blank.radius_mm = 12.0;
        blank.offset_x_mm = work.offset_mm;
        stock.stand_off(blank);
    }
    return stock;
}

class Paths : public ::testing::TestWithParam<Work> {};

/// Turns on by a pulse or jumps, rises now and then, goes in and out smoothly, by leaps or not at all.
TEST_P(Paths, LeaveWhatEachPlaceCutInTurnLeaves) {
    std::mt19937_64 random(17);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    double removed_mm3 = 0.0;
    for (int round = 0; round < 24; ++round) {
        StockMap plain_stock = blank_for(GetParam());
        StockMap stock = blank_for(GetParam());
        ToolCut plain(GetParam().tool, plain_stock);
        ToolSweep sut(GetParam().tool, stock);
        const double pulse_rad = 2.0 * kPi / (round % 3 == 0 ? 200.0 : round % 3 == 1 ? 3200.0 : 25'600.0);
        const double roughness_mm = round % 4 == 0 ? 0.0 : round % 4 == 1 ? 0.01 : round % 4 == 2 ? 0.3 : 3.0;
        double direction_rad = 2.0 * kPi * part(random);
        double height_mm = 10.0 * part(random);
        double tip_mm = 12.0 * part(random);
        for (int step = 0; step < 600; ++step) {
            direction_rad += part(random) < 0.98 ? pulse_rad : (part(random) - 0.5) * 4.0;
            direction_rad -= std::floor(direction_rad / (2.0 * kPi)) * 2.0 * kPi;
            if (direction_rad >= 2.0 * kPi) direction_rad = 0.0;
            if (part(random) < 0.04)
                height_mm = std::clamp(height_mm + 0.4 * (part(random) - 0.4), -2.0, 12.0);
            tip_mm = std::clamp(tip_mm + roughness_mm * (part(random) - 0.5), 0.0, 14.0);
            if (part(random) < 0.01) tip_mm = 12.0 * part(random);
            plain.at(direction_rad, height_mm, tip_mm);
            sut.at(direction_rad, height_mm, tip_mm);
        }
        sut.flush();
        expect_same_bits(stock, plain_stock);
        removed_mm3 += stock.removed_mm3();
    }
    EXPECT_GT(removed_mm3, 0.0);
}

// Sharp, broad, far larger than the piece; columns that are no whole number of blocks, or fewer than one.
INSTANTIATE_TEST_SUITE_P(
    Tools, Paths,
    ::testing::Values(Work{{Shape::ball, 1.5, 0.0}, 720, 0.0}, Work{{Shape::ball, 0.3, 0.0}, 1440, 2.0},
                      Work{{Shape::ball, 9.0, 0.0}, 181, 0.0}, Work{{Shape::flat, 1.0, 0.0}, 720, 0.0},
                      Work{{Shape::flat, 5.0, 0.0}, 187, 3.0}, Work{{Shape::vee, 3.0, 60.0}, 720, 0.0},
                      Work{{Shape::vee, 3.0, 15.0}, 723, 4.0}, Work{{Shape::vee, 6.0, 140.0}, 360, 0.0},
                      Work{{Shape::ball, 3.0, 0.0}, 5, 0.0}, Work{{Shape::point, 0.0, 0.0}, 360, 1.0}),
    [](const auto& named) {
        return psicarve::test::parameter_name(tool_name(named.param.tool), named.index);
    });

TEST(ToolSweep, CutsNothingThatIsNotFlushed) {
    StockMap stock(10.0, 0.0, 0.2, 20, 360);
    ToolSweep sut({Shape::flat, 1.0, 0.0}, stock);
    sut.at(1.0, 2.0, 5.0);
    EXPECT_EQ(stock.removed_mm3(), 0.0);
    sut.flush();
    EXPECT_GT(stock.removed_mm3(), 0.0);
}

}  // namespace
}  // namespace psicarve::piece
