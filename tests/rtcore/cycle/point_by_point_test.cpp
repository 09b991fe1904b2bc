// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/point_by_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace psicarve::cycle {
namespace {

using Point = PointByPoint::Point;

std::string words(PointByPoint sut) {
    std::string text;
    while (!sut.is_finished() && text.size() < 1000) {
        const auto step = sut.next();
        text += text.empty() ? "" : " ";
        text += step.x + step.y > 0 ? "+" : "-";
        text += step.x != 0 ? "X" : "Y";
    }
    return text;
}

TEST(PointByPoint, TheTextbooksLine) {
    EXPECT_EQ(words(PointByPoint::line({6, 4})), "+X +Y +X +Y +X +X +Y +X +Y +X");
}

TEST(PointByPoint, TheTextbooksArc) {
    EXPECT_EQ(words(PointByPoint::arc({4, 0}, {0, 4}, true)), "-X +Y +Y +Y -X +Y -X -X");
}

TEST(PointByPoint, ALineAlongAnAxisHasOnlyItsSteps) {
    EXPECT_EQ(words(PointByPoint::line({3, 0})), "+X +X +X");
    EXPECT_EQ(words(PointByPoint::line({0, -2})), "-Y -Y");
    EXPECT_EQ(words(PointByPoint::line({0, 0})), "");
}

/// Runs it to its end; the number of steps. Every step is one pulse of one axis.
template <typename Check>
int run(PointByPoint& sut, Point at, const Check& check) {
    int steps = 0;
    while (!sut.is_finished()) {
        const auto step = sut.next();
        EXPECT_EQ(std::abs(step.x) + std::abs(step.y), 1);
        at.x += step.x;
        at.y += step.y;
        EXPECT_EQ(at, sut.at());
        if (!check(at) || ++steps > 100'000) {
            ADD_FAILURE() << "step " << steps << " at " << at.x << ", " << at.y;
            break;
        }
    }
    return steps;
}

TEST(PointByPoint, LinesOfAllOctantsEndExactlyAndStayWithinAPulse) {
    std::mt19937_64 random{3};
    for (int round = 0; round < 3000; ++round) {
        const std::uint64_t span = std::uint64_t{1} << (1 + random() % 10);
        const auto pick = [&] {
            return static_cast<std::int64_t>(random() % (2 * span + 1)) - static_cast<std::int64_t>(span);
        };
        const Point end{pick(), pick()};
        const double length = std::hypot(static_cast<double>(end.x), static_cast<double>(end.y));
        PointByPoint sut = PointByPoint::line(end);
        const int steps = run(sut, {0, 0}, [&](Point at) {
            return std::abs(static_cast<double>(end.x * at.y - end.y * at.x)) < length;
        });
        ASSERT_FALSE(::testing::Test::HasFailure()) << end.x << ", " << end.y;
        EXPECT_EQ(sut.at(), end);
        EXPECT_EQ(steps, std::abs(end.x) + std::abs(end.y));
    }
}

// Where an arc begins on an axis, as the textbook's does, its first step is a whole pulse off.
constexpr double kPulse = 1.0 + 1e-9;

/// A point of whole pulses, as near to the circle as it gets.
Point on_circle(double radius, double angle_rad) {
    return {std::llround(radius * std::cos(angle_rad)), std::llround(radius * std::sin(angle_rad))};
}

double turned_rad(Point from, Point to, bool counter_clockwise) {
    const double angle = std::atan2(static_cast<double>(to.y), static_cast<double>(to.x)) -
                         std::atan2(static_cast<double>(from.y), static_cast<double>(from.x));
    const double turn = std::remainder(counter_clockwise ? angle : -angle, 2.0 * M_PI);
    return turn <= 0.0 ? turn + 2.0 * M_PI : turn;
}

TEST(PointByPoint, ArcsOfAllQuadrantsEndExactlyAndStayWithinAPulse) {
    std::mt19937_64 random{5};
    std::uniform_real_distribution<double> angle{-M_PI, M_PI};
    for (int round = 0; round < 4000; ++round) {
        const auto whole_radius = static_cast<double>(2 + random() % (round % 2 == 0 ? 12 : 900));
        const auto on_axis = [&] {
            return on_circle(whole_radius, M_PI / 2.0 * static_cast<double>(random() % 4));
        };
        const Point begin = random() % 4 == 0 ? on_axis() : on_circle(whole_radius, angle(random));
        const double radius = std::hypot(static_cast<double>(begin.x), static_cast<double>(begin.y));
        const Point end = random() % 4 == 0 ? on_axis() : on_circle(radius, angle(random));
        const bool counter_clockwise = random() % 2 == 0;
        PointByPoint sut = PointByPoint::arc(begin, end, counter_clockwise);
        PointByPoint::Point least = begin;
        PointByPoint::Point most = begin;
        const PointByPoint as_begun = sut;
        double turned = 0.0;
        Point before = begin;
        run(sut, begin, [&](Point at) {
            const double step = turned_rad(before, at, counter_clockwise);
            turned += step > M_PI ? step - 2.0 * M_PI : step;
            before = at;
            least = {std::min(least.x, at.x), std::min(least.y, at.y)};
            most = {std::max(most.x, at.x), std::max(most.y, at.y)};
            return std::abs(std::hypot(static_cast<double>(at.x), static_cast<double>(at.y)) - radius) <=
                   kPulse;
        });
        ASSERT_FALSE(::testing::Test::HasFailure()) << "from " << begin.x << ", " << begin.y << " to "
                                                    << end.x << ", " << end.y << " " << counter_clockwise;
        EXPECT_EQ(sut.at(), end);
        // Beyond both of its ends lies only what it passes.
        EXPECT_TRUE(as_begun.passes(1, 0) || most.x <= std::max(begin.x, end.x) + 1);
        EXPECT_TRUE(as_begun.passes(-1, 0) || least.x >= std::min(begin.x, end.x) - 1);
        EXPECT_TRUE(as_begun.passes(0, 1) || most.y <= std::max(begin.y, end.y) + 1);
        EXPECT_TRUE(as_begun.passes(0, -1) || least.y >= std::min(begin.y, end.y) - 1);
        EXPECT_NEAR(turned, turned_rad(begin, end, counter_clockwise), 1e-6)
            << "from " << begin.x << ", " << begin.y << " to " << end.x << ", " << end.y;
    }
}

// From (10, 1) to (11, 1): x has to go out again where the quadrant only leads it in.
TEST(PointByPoint, AnArcWhoseEndIsOffTheCircleByAPulseEndsThereAllTheSame) {
    constexpr int kMost = 13;
    for (int n = 0; n < (2 * kMost + 1) * (2 * kMost + 1); ++n) {
        const Point begin{n % (2 * kMost + 1) - kMost, n / (2 * kMost + 1) - kMost};
        const double radius = std::hypot(static_cast<double>(begin.x), static_cast<double>(begin.y));
        if (radius < 2.0) continue;
        for (int m = 0; m < (2 * kMost + 1) * (2 * kMost + 1); ++m) {
            const Point end{m % (2 * kMost + 1) - kMost, m / (2 * kMost + 1) - kMost};
            if (std::abs(std::hypot(static_cast<double>(end.x), static_cast<double>(end.y)) - radius) > 1.0)
                continue;
            for (const bool counter_clockwise : {true, false}) {
                PointByPoint sut = PointByPoint::arc(begin, end, counter_clockwise);
                int steps = 0;
                double off = 0.0;
                for (; !sut.is_finished() && steps < 20 * kMost; ++steps) {
                    sut.next();
                    const Point at = sut.at();
                    off = std::max(
                        off,
                        std::abs(std::hypot(static_cast<double>(at.x), static_cast<double>(at.y)) - radius));
                }
                ASSERT_EQ(sut.at(), end) << begin.x << ", " << begin.y << " to " << end.x << ", " << end.y;
                ASSERT_LE(off, 1.0 + 1e-9) << begin.x << ", " << begin.y << " to " << end.x << ", " << end.y;
            }
        }
    }
}

TEST(PointByPoint, AnArcBackToItsBeginIsAWholeTurn) {
    for (const Point begin : {Point{50, 0}, Point{0, -50}, Point{30, 40}, Point{-30, 40}}) {
        for (const bool counter_clockwise : {true, false}) {
            PointByPoint sut = PointByPoint::arc(begin, begin, counter_clockwise);
            const int steps = run(sut, begin, [](Point at) {
                return std::abs(std::hypot(static_cast<double>(at.x), static_cast<double>(at.y)) - 50.0) <=
                       kPulse;
            });
            EXPECT_EQ(steps, 8 * 50);
        }
    }
}

}  // namespace
}  // namespace psicarve::cycle
