// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/speed_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace psicarve::plan {
namespace {

constexpr Lanes kAccel{100.0, 200.0, 300.0, 400.0};

struct Chain {
    std::vector<PathCell> cells;
    std::vector<double> bound2;
    std::vector<InnerSpeeds2> inner2;
};

/// Straight along axis 0, at one pulse per u.
Chain straight(std::size_t count, double length, double speed) {
    Chain chain;
    PathCell cell{};
    cell.length = length;
    cell.slope_begin[0] = cell.slope_end[0] = 1.0;
    chain.cells.assign(count, cell);
    chain.bound2.assign(count + 1, speed * speed);
    chain.inner2.assign(count, {speed * speed, speed * speed, speed * speed});
    return chain;
}

Chain random_chain(std::mt19937_64& random, std::size_t count) {
    std::uniform_real_distribution<double> slope{-50.0, 50.0};
    std::uniform_real_distribution<double> length{0.01, 0.2};
    std::uniform_real_distribution<double> limit{0.1, 9.0};
    Chain chain;
    Lanes at{};
    for (double& value : at) value = slope(random);
    for (std::size_t i = 0; i < count; ++i) {
        PathCell cell{};
        cell.length = length(random);
        cell.slope_begin = at;
        for (double& value : at) value += 0.2 * slope(random);
        cell.slope_end = at;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            cell.bend[k] = (cell.slope_end[k] - cell.slope_begin[k]) / cell.length;
        }
        chain.cells.push_back(cell);
        chain.bound2.push_back(limit(random));
        chain.inner2.push_back({limit(random), limit(random), limit(random)});
    }
    chain.bound2.push_back(limit(random));
    return chain;
}

std::vector<double> solved(const Chain& chain) {
    SpeedProfile profile{kAccel};
    std::vector<double> speed2;
    profile.set_path(chain.cells);
    profile.solve({chain.bound2, chain.inner2}, speed2);
    return speed2;
}

double inner_share(const InnerSpeeds2& limit2, double begin2, double end2) {
    double share = 0.0;
    for (std::size_t i = 0; i < limit2.size(); ++i) {
        share = std::max(share, (begin2 + 0.25 * static_cast<double>(i + 1) * (end2 - begin2)) / limit2[i]);
    }
    return share;
}

/// Of what it may, the axis that asks for most; at a cell's ends that is a little more than in the middle.
double accel_share(const PathCell& cell, double begin2, double end2, double at) {
    const double rise = 0.5 * (end2 - begin2) / cell.length;
    const double speed2 = begin2 + at * (end2 - begin2);
    double share = 0.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double slope = cell.slope_begin[k] + at * (cell.slope_end[k] - cell.slope_begin[k]);
        const double most =
            at == 0.5 ? kAccel[k] : kAccel[k] * greatest_end_share(cell.length, 1.0 / kAccel[k]);
        share = std::max(share, std::abs(slope * rise + cell.bend[k] * speed2) / most);
    }
    return share;
}

TEST(SpeedProfile, TwoTimingsSideBySideAreThoseOneAfterTheOther) {
    std::mt19937_64 random{77};
    for (int chain = 0; chain < 20; ++chain) {
        const Chain slow = random_chain(random, 300);
        Chain fast = slow;
        for (double& limit : fast.bound2) limit *= 4.0;
        for (InnerSpeeds2& limits : fast.inner2) {
            for (double& limit : limits) limit *= 4.0;
        }
        SpeedProfile profile{kAccel};
        std::array<std::vector<double>, 2> both;
        profile.set_path(slow.cells);
        profile.solve_both({SpeedLimits{slow.bound2, slow.inner2}, SpeedLimits{fast.bound2, fast.inner2}},
                           both);
        EXPECT_EQ(both[0], solved(slow));
        EXPECT_EQ(both[1], solved(fast));
    }
}

TEST(SpeedProfile, AStraightWayIsATrapezoid) {
    Chain chain = straight(400, 0.01, 10.0);
    chain.bound2.front() = chain.bound2.back() = 0.0;
    const std::vector<double> speed2 = solved(chain);
    double seconds = 0.0;
    for (std::size_t i = 0; i < chain.cells.size(); ++i) {
        seconds += cell_seconds(chain.cells[i].length, speed2[i], speed2[i + 1]);
    }
    // 4 long, 100 of acceleration, 10 of speed: two ramps of 0.1 s and 0.5 each, 0.3 s in between.
    EXPECT_NEAR(seconds, 0.5, 1e-6);
}

TEST(SpeedProfile, ACircleIsAsFastAsItsCentreAllows) {
    // q0 = cos u, q1 = sin u: every axis' acceleration is at most (du/dt)^2.
    Chain chain;
    constexpr std::size_t kCount = 2000;
    const double step = 6.0 / kCount;
    for (std::size_t i = 0; i < kCount; ++i) {
        const double u = static_cast<double>(i) * step;
        PathCell cell{};
        cell.length = step;
        cell.slope_begin = {-std::sin(u), std::cos(u), 0.0, 0.0};
        cell.slope_end = {-std::sin(u + step), std::cos(u + step), 0.0, 0.0};
        for (std::size_t k = 0; k < 2; ++k) {
            cell.bend[k] = (cell.slope_end[k] - cell.slope_begin[k]) / step;
        }
        chain.cells.push_back(cell);
    }
    chain.bound2.assign(kCount + 1, 1e6);
    chain.inner2.assign(kCount, {1e6, 1e6, 1e6});
    const std::vector<double> speed2 = solved(chain);
    for (std::size_t i = 0; i < kCount; ++i) {
        EXPECT_LE(accel_share(chain.cells[i], speed2[i], speed2[i + 1], 0.5), 1.0 + 1e-9);
    }
    // Axis 0 asks for no more than 100 where it turns back; in between it may be faster.
    const double least = *std::min_element(speed2.begin(), speed2.end());
    EXPECT_NEAR(least, 100.0, 2.0);
    EXPECT_GT(*std::max_element(speed2.begin(), speed2.end()), 105.0);
}

TEST(SpeedProfile, RandomChainsStayWithinEveryLimit) {
    std::mt19937_64 random{11};
    for (int round = 0; round < 300; ++round) {
        const Chain chain = random_chain(random, 2 + random() % 80);
        const std::vector<double> speed2 = solved(chain);
        ASSERT_EQ(speed2.size(), chain.cells.size() + 1);
        for (std::size_t i = 0; i < chain.cells.size(); ++i) {
            ASSERT_LE(speed2[i], chain.bound2[i] * (1.0 + 1e-9));
            ASSERT_LE(inner_share(chain.inner2[i], speed2[i], speed2[i + 1]), 1.0 + 1e-9);
            ASSERT_GT(speed2[i], 0.0);
            ASSERT_LE(accel_share(chain.cells[i], speed2[i], speed2[i + 1], 0.5), 1.0 + 1e-6) << round;
            ASSERT_LE(accel_share(chain.cells[i], speed2[i], speed2[i + 1], 0.0), 1.0 + 1e-6) << round;
            ASSERT_LE(accel_share(chain.cells[i], speed2[i], speed2[i + 1], 1.0), 1.0 + 1e-6) << round;
        }
    }
}

TEST(SpeedProfile, ACellsEndsMayAskForAQuarterMoreAndForLessInALongCell) {
    EXPECT_DOUBLE_EQ(greatest_end_share(0.001, 1.0 / 100.0), 1.25);
    // excess * a * t^2 / 62.4 = a fiftieth of a pulse.
    EXPECT_NEAR((greatest_end_share(0.5, 1.0 / 100.0) - 1.0) * 100.0 * 0.25 / 62.4, 0.02, 1e-12);
}

// Greedy passes are optimal here: no feasible timing is faster anywhere. Found by bisection on each cell.
TEST(SpeedProfile, NoSingleSpeedCanBeRaised) {
    std::mt19937_64 random{5};
    for (int round = 0; round < 50; ++round) {
        const Chain chain = random_chain(random, 40);
        const std::vector<double> speed2 = solved(chain);
        for (std::size_t i = 1; i < chain.cells.size(); ++i) {
            const double raised = speed2[i] * 1.01;
            const auto is_broken = [&](std::size_t cell, double begin2, double end2) {
                const PathCell& of = chain.cells[cell];
                return accel_share(of, begin2, end2, 0.5) > 1.0 || accel_share(of, begin2, end2, 0.0) > 1.0 ||
                       accel_share(of, begin2, end2, 1.0) > 1.0 ||
                       inner_share(chain.inner2[cell], begin2, end2) > 1.0;
            };
            EXPECT_TRUE(raised > chain.bound2[i] || is_broken(i - 1, speed2[i - 1], raised) ||
                        is_broken(i, raised, speed2[i + 1]))
                << round << " " << i;
        }
    }
}

TEST(SpeedProfile, ACellBeginsAtTheGreatestSpeedThatLetsItEndWithinItsLimit) {
    std::mt19937_64 random{29};
    constexpr int kParts = 80;
    for (int round = 0; round < 300; ++round) {
        const Chain chain = random_chain(random, 1);
        const PathCell& cell = chain.cells[0];
        const double found2 = solved(chain)[0];
        for (int i = 1; i <= kParts; ++i) {
            const double begin2 = chain.bound2[0] * i / kParts;
            if (begin2 <= 1.001 * found2) continue;
            for (int j = 0; j <= kParts; ++j) {
                const double end2 = chain.bound2[1] * j / kParts;
                const double asked = std::max(
                    {accel_share(cell, begin2, end2, 0.0), accel_share(cell, begin2, end2, 0.5),
                     accel_share(cell, begin2, end2, 1.0), inner_share(chain.inner2[0], begin2, end2)});
                ASSERT_GT(asked, 1.0) << round << ": " << begin2 << " is possible, not " << found2;
            }
        }
    }
}

}  // namespace
}  // namespace psicarve::plan
