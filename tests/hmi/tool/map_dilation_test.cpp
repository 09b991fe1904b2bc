// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/map_dilation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "shared/base/units.hpp"

namespace psicarve::tool {
namespace {

struct Sampled {
    std::vector<float> radius;
    SampledRadii view;
};

template <typename Radius>
Sampled sampled(std::size_t rows, std::size_t columns, double pitch, const Radius& radius_at) {
    Sampled out;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column)
            out.radius.push_back(static_cast<float>(
                radius_at(2.0 * kPi * static_cast<double>(column) / static_cast<double>(columns),
                          static_cast<double>(row) * pitch)));
    }
    out.view = {rows, columns, pitch, out.radius};
    return out;
}

/// The definition: all samples, one after the other.
double plain_tip(const Sampled& map, const Tool& tool, double direction_rad, double height) {
    double most = 0.0;
    for (std::size_t i = 0; i < map.radius.size(); ++i) {
        const double r = static_cast<double>(map.radius[i]);
        const double turn = 2.0 * kPi * static_cast<double>(i % map.view.column_count) /
                                static_cast<double>(map.view.column_count) -
                            direction_rad;
        const double up = static_cast<double>(i / map.view.column_count) * map.view.row_pitch - height;
        const double s = std::hypot(r * std::sin(turn), up);
        if (std::cos(turn) <= 0.0 || s > tool.radius) continue;
        most = std::max(most, r * std::cos(turn) - rise(tool, s));
    }
    return most;
}

double direction_of(const Sampled& map, std::size_t place) {
    return 2.0 * kPi * static_cast<double>(place % map.view.column_count) /
           static_cast<double>(map.view.column_count);
}

double height_of(const Sampled& map, std::size_t place) {
    return static_cast<double>(place / map.view.column_count) * map.view.row_pitch;
}

const std::vector<Tool> kTools{{Shape::ball, 1.5137, 0.0},
                               {Shape::flat, 1.0071, 0.0},
                               {Shape::vee, 2.0093, 60.0},
                               {Shape::ball, 30.0, 0.0}};

void expect_as_defined(const Sampled& map) {
    for (const Tool& tool : kTools) {
        const auto tips = dilated(map.view, tool, 0.0, {2, {}});
        ASSERT_TRUE(tips);
        for (std::size_t place = 0; place < map.radius.size(); ++place)
            ASSERT_NEAR((*tips)[place], plain_tip(map, tool, direction_of(map, place), height_of(map, place)),
                        5e-5)
                << "tool " << name_of(tool.shape) << " place " << place;
    }
}

TEST(MapDilation, IsTheDefinitionOnASmoothBody) {
    expect_as_defined(sampled(37, 90, 0.31, [](double t, double y) {
        return 9.0 + 2.0 * std::sin(3.0 * t + y) + std::cos(1.7 * y);
    }));
}

TEST(MapDilation, IsTheDefinitionOnRandomSamplesWithHolesAndAnOddTurn) {
    for (const unsigned seed : {1U, 2U}) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> radius(0.0, 12.0);
        std::uniform_int_distribution<int> has_hole(0, 9);
        expect_as_defined(sampled(
            19, 67, 0.4, [&](double, double) { return has_hole(random) == 0 ? 0.0 : radius(random); }));
    }
}

TEST(MapDilation, IsTheDefinitionOnNeedlesStepsAndHolesSteepAndFlat) {
    for (const unsigned seed : {3U, 4U}) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        const double wave = 1.0 + std::floor(5.0 * share(random));
        const double lean = 2.0 * share(random);
        const double step = 4.0 * share(random);
        const double step_at = 3.0 * share(random);
        expect_as_defined(sampled(20 + seed, 97, 0.17, [&](double t, double y) {
            const double smooth = 6.0 + std::sin(wave * t + lean * y) + (y > step_at ? step : 0.0);
            const double chance = share(random);
            if (chance < 0.01) return smooth + 5.0 * share(random);
            return chance > 0.97 && y > step_at ? 0.0 : smooth;
        }));
    }
}

/// Where a place stands out of its block alone, all others of it are far from its middle, and a wall beside
/// it is seen across.
TEST(MapDilation, IsTheDefinitionOnNeedlesBesideAWall) {
    for (std::size_t needle = 0; needle < 32; needle += 5) {
        for (const double height : {0.3, 1.6}) {
            const Sampled map = sampled(40, 360, 0.1, [&](double t, double y) {
                const auto row = static_cast<std::size_t>(std::lround(y / 0.1));
                const auto column = static_cast<std::size_t>(std::lround(t / (2.0 * kPi) * 360.0));
                if (row == 16 + needle / 8 && column == 64 + needle % 8) return 6.0 + height;
                return row > 24 ? 8.0 : 6.0;
            });
            const Tool tool{Shape::ball, 1.3137, 0.0};
            const auto tips = dilated(map.view, tool, 0.0, {2, {}});
            ASSERT_TRUE(tips);
            for (std::size_t row = 8; row < 32; row += 2) {
                for (std::size_t column = 56; column < 80; column += 3) {
                    const std::size_t place = row * 360 + column;
                    ASSERT_NEAR((*tips)[place],
                                plain_tip(map, tool, direction_of(map, place), height_of(map, place)), 5e-5)
                        << "needle " << needle << " of " << height << ", place " << row << ", " << column;
                }
            }
        }
    }
}

/// A whole tile of samples may stand further out than a ball beside it, out of reach of its centre.
TEST(MapDilation, IsTheDefinitionBesideAPillarTallerThanTheBall) {
    const Sampled map = sampled(48, 360, 0.1, [](double t, double y) {
        const auto row = std::lround(y / 0.1);
        const auto column = std::lround(t / (2.0 * kPi) * 360.0);
        return row >= 20 && row < 24 && column >= 100 && column < 104 ? 12.0 : 6.0;
    });
    const Tool tool{Shape::ball, 1.3137, 0.0};
    const auto tips = dilated(map.view, tool, 0.0, {2, {}});
    ASSERT_TRUE(tips);
    for (std::size_t row = 4; row < 40; ++row) {
        for (std::size_t column = 84; column < 120; ++column) {
            const std::size_t place = row * 360 + column;
            ASSERT_NEAR((*tips)[place], plain_tip(map, tool, direction_of(map, place), height_of(map, place)),
                        5e-5)
                << "place " << row << ", " << column;
        }
    }
}

/// Then a block is wider than half a turn.
TEST(MapDilation, IsTheDefinitionWithHardlyAnyColumns) {
    for (std::size_t columns = 4; columns < 16; ++columns) {
        for (std::size_t odd = 0; odd < columns; ++odd) {
            for (const Tool& tool : {Tool{Shape::flat, 1.0, 0.0}, Tool{Shape::ball, 1.0, 0.0}}) {
                Sampled map = sampled(4, columns, 0.1, [](double, double) { return 0.9; });
                map.radius[3 * columns + odd] = 1.0F;
                map.view.radius = map.radius;
                const auto tips = dilated(map.view, tool, 0.0, {1, {}});
                ASSERT_TRUE(tips);
                for (std::size_t place = 0; place < map.radius.size(); ++place)
                    ASSERT_NEAR((*tips)[place],
                                plain_tip(map, tool, direction_of(map, place), height_of(map, place)), 5e-5)
                        << name_of(tool.shape) << ", " << columns << " columns, place " << place;
            }
        }
    }
}

/// Far from the origin single precision takes the most, and where samples stand dense the bounds decide most.
TEST(MapDilation, IsTheDefinitionOnDenseSamplesOfABodyMuchLargerThanTheTool) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> grain(-0.02, 0.02);
    const Sampled map = sampled(60, 720, 0.25, [&](double t, double y) {
        return 40.0 + 2.0 * std::sin(7.0 * t + 0.3 * y) + 0.5 * std::cos(57.0 * t - y) + grain(random);
    });
    for (const Tool& tool : {Tool{Shape::ball, 3.0, 0.0}, Tool{Shape::ball, 0.7, 0.0},
                             Tool{Shape::vee, 3.0013, 60.0}, Tool{Shape::flat, 2.9137, 0.0}}) {
        const auto tips = dilated(map.view, tool, 0.0, {2, {}});
        ASSERT_TRUE(tips);
        for (std::size_t place = 0; place < map.radius.size(); place += 223)
            ASSERT_NEAR((*tips)[place], plain_tip(map, tool, direction_of(map, place), height_of(map, place)),
                        5e-5)
                << "tool " << name_of(tool.shape) << " place " << place;
    }
}

TEST(MapDilation, IsTheDefinitionWithFewRowsAndColumnsAndNearTheAxis) {
    expect_as_defined(sampled(1, 4, 1.0, [](double t, double) { return 3.0 + std::cos(t); }));
    expect_as_defined(sampled(5, 9, 0.5, [](double t, double) { return 0.2 + 0.1 * std::sin(t); }));
}

TEST(MapDilation, ReachesRoundTheSeam) {
    const Sampled map =
        sampled(9, 120, 0.2, [](double t, double) { return t > 2.0 * kPi - 0.06 ? 10.0 : 8.0; });
    const Tool tool{Shape::flat, 1.0, 0.0};
    const auto tips = dilated(map.view, tool, 0.0, {1, {}});
    ASSERT_TRUE(tips);
    EXPECT_GT((*tips)[4 * 120], 9.9);
    EXPECT_GT((*tips)[4 * 120 + 118], 9.9);
    EXPECT_LT((*tips)[4 * 120 + 60], 8.1);
}

TEST(MapDilation, IsTheSameOnAnyNumberOfThreadsAndAddsItsAllowance) {
    const Sampled map = sampled(40, 100, 0.2, [](double t, double y) { return 8.0 + std::sin(5.0 * t + y); });
    const auto one = dilated(map.view, kTools[0], 0.0, {1, {}});
    const auto three = dilated(map.view, kTools[0], 0.0, {3, {}});
    const auto more = dilated(map.view, kTools[0], 0.25, {2, {}});
    ASSERT_TRUE(one && three && more);
    EXPECT_EQ(*one, *three);
    for (std::size_t i = 0; i < one->size(); ++i) ASSERT_FLOAT_EQ((*one)[i] + 0.25F, (*more)[i]);
}

TEST(MapDilation, WithItsAllowanceIsNowhereDeeperThanTheSurfaceItself) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> wave(0.5, 4.0);
    for (int body = 0; body < 3; ++body) {
        const double a = wave(random);
        const double b = wave(random);
        const double round = std::floor(wave(random) * 2.0);
        const auto radius = [=](double t, double y) {
            return 10.0 + 0.8 * std::sin(round * t + a) + 0.7 * std::cos(b * 0.4 * y);
        };
        const Sampled coarse = sampled(13, 96, 0.4, radius);
        const Sampled fine = sampled(13 * 6 - 5, 96 * 6, 0.4 / 6.0, radius);
        for (const Tool& tool : {Tool{Shape::ball, 1.5, 0.0}, Tool{Shape::ball, 3.0, 0.0}}) {
            const double allowance = sample_allowance(coarse.view, tool, 1.0);
            EXPECT_LT(allowance, 0.3);
            const auto tips = dilated(coarse.view, tool, allowance, {2, {}});
            ASSERT_TRUE(tips);
            for (std::size_t place = static_cast<std::size_t>(body); place < tips->size(); place += 97)
                ASSERT_GE((*tips)[place],
                          plain_tip(fine, tool, direction_of(coarse, place), height_of(coarse, place)));
        }
    }
}

TEST(MapDilation, IsCancelled) {
    const Sampled map = sampled(40, 100, 0.2, [](double, double) { return 8.0; });
    const auto tips = dilated(map.view, kTools[0], 0.0, {1, [](double) { return false; }});
    ASSERT_FALSE(tips);
    EXPECT_EQ(tips.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace psicarve::tool
