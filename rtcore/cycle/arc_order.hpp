// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/motion_order.hpp"
#include "rtcore/cycle/point_by_point.hpp"
#include "rtcore/cycle/soft_limits.hpp"

namespace psicarve::cycle {

constexpr bool is_arc(const MotionOrder& order) noexcept {
    return order.shape == OrderShape::arc || order.shape == OrderShape::clockwise;
}

/// An order's two axes and, for an arc, where it runs as seen from its centre.
struct ArcInPlane {
    std::array<std::size_t, 2> axes{};  ///< the first and the second of the order's axes
    std::array<std::int64_t, 2> centre_pulses{};
    PointByPoint::Point begin{};
    PointByPoint::Point end{};
    bool counter_clockwise = true;
    std::int64_t radius_pulses = 0;
    bool is_arc = false;  ///< both ends are as far from the centre, to a pulse, and that is 2 pulses or more
};

/// RT: yes, as all here.
ArcInPlane arc_of(const MotionOrder& order, const std::array<std::int64_t, kAxisCount>& from,
                  const std::array<std::int64_t, kAxisCount>& to) noexcept;

/// The first soft limit that the arc breaks where it reaches out furthest; its ends are another matter.
SoftBreach breach_on_arc(const SoftLimits& limits, const ArcInPlane& arc,
                         const std::array<std::int64_t, kAxisCount>& from) noexcept;

}  // namespace psicarve::cycle
