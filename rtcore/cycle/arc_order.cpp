// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/arc_order.hpp"

#include <cmath>

namespace psicarve::cycle {
namespace {

constexpr std::int64_t kLeastRadius = 2;
constexpr std::int64_t kLargestRadius = std::int64_t{1} << 30;

double distance(PointByPoint::Point at) noexcept {
    const auto x = static_cast<double>(at.x);
    const auto y = static_cast<double>(at.y);
    return std::sqrt(x * x + y * y);
}

}  // namespace

ArcInPlane arc_of(const MotionOrder& order, const std::array<std::int64_t, kAxisCount>& from,
                  const std::array<std::int64_t, kAxisCount>& to) noexcept {
    ArcInPlane arc;
    std::size_t found = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if ((order.axes >> k & 1U) != 0 && found < arc.axes.size()) arc.axes[found++] = k;
    }
    // A line of one axis alone has any other beside it.
    if (found < 2) arc.axes[1] = arc.axes[0] == 0 ? 1 : 0;
    arc.centre_pulses = order.centre_pulses;
    arc.counter_clockwise = order.shape == OrderShape::arc;
    const auto seen = [&](const std::array<std::int64_t, kAxisCount>& at) noexcept {
        return PointByPoint::Point{at[arc.axes[0]] - arc.centre_pulses[0],
                                   at[arc.axes[1]] - arc.centre_pulses[1]};
    };
    arc.begin = seen(from);
    arc.end = seen(to);
    const double radius = distance(arc.begin);
    if (radius < static_cast<double>(kLeastRadius) || radius > static_cast<double>(kLargestRadius))
        return arc;
    arc.radius_pulses = static_cast<std::int64_t>(std::ceil(radius));
    arc.is_arc = found == 2 && std::fabs(distance(arc.end) - radius) <= 1.0;
    return arc;
}

SoftBreach breach_on_arc(const SoftLimits& limits, const ArcInPlane& arc,
                         const std::array<std::int64_t, kAxisCount>& from) noexcept {
    constexpr std::array<std::array<int, 2>, 4> kEnds{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    const PointByPoint way = PointByPoint::arc(arc.begin, arc.end, arc.counter_clockwise);
    for (const auto& [x, y] : kEnds) {
        if (!way.passes(x, y)) continue;
        auto at = from;
        at[arc.axes[0]] = arc.centre_pulses[0] + x * arc.radius_pulses;
        at[arc.axes[1]] = arc.centre_pulses[1] + y * arc.radius_pulses;
        const SoftBreach breach = first_breach(limits, from, at);
        if (breach.limit != SoftLimit::none) return breach;
    }
    return {};
}

}  // namespace psicarve::cycle
