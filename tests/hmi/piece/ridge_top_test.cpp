// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "hmi/slice/directions.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/piece/deviation_rig.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::piece {
namespace {

/// A round column of radius 9 and height 10 with a roof that runs out from it to radius 14: its ridge lies
/// at `top_mm`, its slopes fall by 45 degrees on both sides.
model::Mesh with_roof(double direction_deg, double top_mm) {
    const double turn = direction_deg * kPi / 180.0;
    const auto at = [&](double out, double across, double height) {
        return shapes::Point{out * std::cos(turn) - across * std::sin(turn),
                             out * std::sin(turn) + across * std::cos(turn), height};
    };
    constexpr double kInner = 6.0;
    constexpr double kOuter = 14.0;
    constexpr double kHalf = 1.5;
    const double foot = top_mm - kHalf;
    const auto a = [&](double out) { return at(out, -kHalf, foot); };
    const auto b = [&](double out) { return at(out, kHalf, foot); };
    const auto c = [&](double out) { return at(out, 0.0, top_mm); };
    shapes::Builder roof;
    roof.facet(a(kOuter), b(kOuter), c(kOuter)).facet(b(kInner), a(kInner), c(kInner));
    roof.quad(a(kInner), b(kInner), b(kOuter), a(kOuter));
    roof.quad(b(kInner), c(kInner), c(kOuter), b(kOuter));
    roof.quad(c(kInner), a(kInner), a(kOuter), c(kOuter));
    return shapes::Builder().add(shapes::cylinder(9.0, 0.0, 10.0, 360)).add(roof.mesh()).mesh();
}

// Between two points of a layer the tool takes the ridge's top off, by a tenth of a millimetre: along the
// ridge's own ray, which then goes over what is left, that is 5 mm.
TEST(RidgeTop, ThatIsTakenOffIsAsMuchAsIsTakenOffWhereverTheRowsLie) {
    const Profile profile = with_tool(ToolShape::ball, 2.0, 0.0);
    const auto round = slice::full_circle_rad(400, profile.psi.pulses_per_rev, 0.0);
    const double direction_deg = deg_from_rad(0.5 * (round[50] + round[51]));
    for (const double top_mm : {4.0, 4.04, 4.1, 4.12}) {
        for (const std::size_t columns : {720U, 1440U}) {
            if (!psicarve::test::is_thorough() && (top_mm != 4.1 || columns != 720)) continue;
            const PieceDeviation sut = carved(with_roof(direction_deg, top_mm), profile, 100, 400, columns);
            EXPECT_GT(sut.gouge.max_mm, 0.03) << top_mm << ' ' << columns;
            EXPECT_LT(sut.gouge.max_mm, 0.1 + sut.cell_mm) << top_mm << ' ' << columns;
        }
    }
}

}  // namespace
}  // namespace psicarve::piece
