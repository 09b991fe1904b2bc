// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/polar_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

struct RandomWays {
    std::mt19937 random{20260714};

    double within(double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(random);
    }
    PlanePoint point() {
        const double radius_mm = std::exp(within(std::log(0.05), std::log(60.0)));
        const double angle_rad = within(-kPi, kPi);
        return {radius_mm * std::cos(angle_rad), radius_mm * std::sin(angle_rad)};
    }
    PolarWay line() { return PolarWay::line(point(), point()); }
    /// Mostly true ones; of some the radii differ as much as an arc's may.
    PolarWay arc() {
        const PlanePoint from = point();
        const PlanePoint centre = point();
        const double sweep_rad = within(-1.0, 1.0) * within(0.1, 15.0);
        const double first_mm = from.first_mm - centre.first_mm;
        const double second_mm = from.second_mm - centre.second_mm;
        const double begin_mm = std::hypot(first_mm, second_mm);
        const double end_mm =
            begin_mm + (random() % 3 == 0 ? within(-0.3, 0.3) * std::min(1.0, begin_mm) : 0.0);
        const double end_rad = std::atan2(second_mm, first_mm) + sweep_rad;
        const PlanePoint to{centre.first_mm + end_mm * std::cos(end_rad),
                            centre.second_mm + end_mm * std::sin(end_rad)};
        return PolarWay::arc(from, to, centre, sweep_rad);
    }
    PolarWay any() { return random() % 2 == 0 ? line() : arc(); }
};

double distance_mm(const PlanePoint& point) {
    return std::hypot(point.first_mm, point.second_mm);
}

/// How far a machine that goes evenly in distance and direction is from the way, at equal times.
double measured_deviation_mm(const PolarWay& way, double from, double to) {
    const double begin_mm = distance_mm(way.at(from));
    const double end_mm = distance_mm(way.at(to));
    const PlanePoint origin = way.at(0.0);
    const double origin_rad = std::atan2(origin.second_mm, origin.first_mm);
    double most_mm = 0.0;
    for (int i = 1; i < 64; ++i) {
        const double part = i / 64.0;
        const double radius_mm = begin_mm + part * (end_mm - begin_mm);
        const double turned_rad = way.turned_rad(from) + part * (way.turned_rad(to) - way.turned_rad(from));
        const PlanePoint ideal = way.at(from + part * (to - from));
        most_mm =
            std::max(most_mm, std::hypot(radius_mm * std::cos(origin_rad + turned_rad) - ideal.first_mm,
                                         radius_mm * std::sin(origin_rad + turned_rad) - ideal.second_mm));
    }
    return most_mm;
}

TEST(PolarWays, DeviateNoFurtherThanTheirBoundSays) {
    RandomWays ways;
    int judged = 0;
    int tight = 0;
    for (int i = 0; i < 20'000; ++i) {
        const PolarWay sut = ways.any();
        const double from = ways.within(0.0, 0.9);
        const double to = from + std::exp(ways.within(std::log(1e-4), std::log(1.0 - from)));
        if (sut.least_radius_mm(from, to) < 1e-3) continue;
        const double bound_mm = sut.deviation_mm(from, to);
        const double found_mm = measured_deviation_mm(sut, from, to);
        ASSERT_LE(found_mm, bound_mm + 1e-9) << i;
        ++judged;
        if (found_mm > bound_mm / 3.0) ++tight;
    }
    EXPECT_GT(judged, 15'000);
    // And it is not just large: pieces as short as they are used are near it.
    EXPECT_GT(tight, judged / 4);
}

TEST(PolarWays, TurnWithoutAJumpHoweverManyTurnsTheyHave) {
    RandomWays ways;
    for (int i = 0; i < 3'000; ++i) {
        const PolarWay sut = ways.any();
        if (sut.least_radius_mm(0.0, 1.0) < 0.01) continue;
        double before_rad = 0.0;
        PlanePoint at = sut.at(0.0);
        for (int step = 1; step <= 4'000; ++step) {
            const double share = step / 4'000.0;
            const PlanePoint next = sut.at(share);
            const double turn_rad = std::atan2(at.first_mm * next.second_mm - at.second_mm * next.first_mm,
                                               at.first_mm * next.first_mm + at.second_mm * next.second_mm);
            ASSERT_NEAR(sut.turned_rad(share) - before_rad, turn_rad, 1e-6) << i;
            before_rad = sut.turned_rad(share);
            at = next;
        }
    }
}

TEST(PolarWays, KnowTheirPointNearestToTheAxis) {
    RandomWays ways;
    for (int i = 0; i < 5'000; ++i) {
        const PolarWay sut = ways.any();
        double least_mm = 1e9;
        for (int step = 0; step <= 2'000; ++step)
            least_mm = std::min(least_mm, distance_mm(sut.at(step / 2'000.0)));
        ASSERT_LE(sut.least_radius_mm(0.0, 1.0), least_mm + 1e-9) << i;
        // Where the radii of an arc differ, by half of that less.
        ASSERT_GE(sut.least_radius_mm(0.0, 1.0), least_mm - 0.31) << i;
        ASSERT_LE(distance_mm(sut.at(sut.nearest_share())), least_mm + 0.31) << i;
    }
}

TEST(PolarWays, AboutTheAxisAndAwayFromItAreEven) {
    const PolarWay turns = PolarWay::arc({20.0, 0.0}, {20.0, 0.0}, {0.0, 0.0}, 6.0 * kPi);
    EXPECT_NEAR(turns.turned_rad(1.0), 6.0 * kPi, 1e-12);
    EXPECT_LT(turns.deviation_mm(0.0, 1.0), 1e-9);
    const PolarWay ray = PolarWay::line({3.0, 4.0}, {30.0, 40.0});
    EXPECT_LT(ray.deviation_mm(0.0, 1.0), 1e-9);
    EXPECT_NEAR(ray.turned_rad(1.0), 0.0, 1e-12);
}

}  // namespace
}  // namespace psicarve::gcode
