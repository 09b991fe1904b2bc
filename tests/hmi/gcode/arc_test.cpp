// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

TEST(ArcRadii, MayDifferByFiveMicrometresOrAThousandthButNotByHalfAMillimetre) {
    const auto differs = [](double radius_mm, double by_mm) {
        return centre_fault({radius_mm, 0.0}, {-radius_mm - by_mm, 0.0}, {0.0, 0.0}).has_value();
    };
    EXPECT_FALSE(differs(1.0, 0.0049));
    EXPECT_TRUE(differs(1.0, 0.0051));
    EXPECT_FALSE(differs(100.0, 0.099));
    EXPECT_TRUE(differs(100.0, 0.101));
    EXPECT_FALSE(differs(1000.0, 0.499));
    EXPECT_TRUE(differs(1000.0, 0.501));
}

TEST(ArcSweep, TurnsTheWayItIsToldAndAsOften) {
    const PlanePoint east{1.0, 0.0};
    const PlanePoint north{0.0, 1.0};
    const PlanePoint middle{0.0, 0.0};
    EXPECT_NEAR(sweep_rad(east, north, middle, 1), kPi / 2.0, 1e-12);
    EXPECT_NEAR(sweep_rad(east, north, middle, -1), -1.5 * kPi, 1e-12);
    EXPECT_NEAR(sweep_rad(east, north, middle, 3), 4.5 * kPi, 1e-12);
    EXPECT_NEAR(sweep_rad(east, east, middle, 1), 2.0 * kPi, 1e-12);
    EXPECT_NEAR(sweep_rad(east, east, middle, -2), -4.0 * kPi, 1e-12);
}

TEST(ArcCentre, LiesOnTheSideOfTheSignAndTheTurn) {
    std::optional<ArcFault> fault;
    const auto second_mm = [&](double radius_mm, bool is_clockwise) {
        return centre_of_radius({0.0, 0.0}, {6.0, 0.0}, radius_mm, is_clockwise, fault)->second_mm;
    };
    EXPECT_NEAR(second_mm(5.0, true), -4.0, 1e-12);
    EXPECT_NEAR(second_mm(-5.0, true), 4.0, 1e-12);
    EXPECT_NEAR(second_mm(5.0, false), 4.0, 1e-12);
    EXPECT_NEAR(second_mm(-5.0, false), -4.0, 1e-12);
    EXPECT_FALSE(fault.has_value());
}

}  // namespace
}  // namespace psicarve::gcode
