// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/point_by_point.hpp"

#include <cstdlib>

namespace psicarve::cycle {
namespace {

using Point = PointByPoint::Point;
using Step = PointByPoint::Step;

constexpr int kQuadrants = 4;
/// By quadrant, counter-clockwise.
constexpr Step kDirections[kQuadrants]{{-1, 1}, {-1, -1}, {1, -1}, {1, 1}};

/// The quadrant that an arc at this point is about to cross: a point on an axis belongs to the one ahead.
int quadrant_ahead(Point at) noexcept {
    if (at.x > 0 && at.y >= 0) return 0;
    if (at.x <= 0 && at.y > 0) return 1;
    return at.x < 0 ? 2 : 3;
}

/// The one that it has just crossed: a point on an axis belongs to the one behind.
int quadrant_behind(Point at) noexcept {
    if (at.x >= 0 && at.y > 0) return 0;
    if (at.x < 0 && at.y >= 0) return 1;
    return at.y < 0 && at.x <= 0 ? 2 : 3;
}

bool lies_ahead(Point from, Point to, Step directions) noexcept {
    return from != to && (to.x - from.x) * directions.x >= 0 && (to.y - from.y) * directions.y >= 0;
}

}  // namespace

PointByPoint PointByPoint::line(Point end) noexcept {
    PointByPoint line;
    line.x_sign_ = end.x < 0 ? -1 : 1;
    line.y_sign_ = end.y < 0 ? -1 : 1;
    line.end_ = {std::abs(end.x), std::abs(end.y)};
    return line;
}

PointByPoint PointByPoint::arc(Point begin, Point end, bool counter_clockwise) noexcept {
    PointByPoint arc;
    arc.is_arc_ = true;
    arc.y_sign_ = counter_clockwise ? 1 : -1;
    arc.at_ = {begin.x, begin.y * arc.y_sign_};
    arc.end_ = {end.x, end.y * arc.y_sign_};
    arc.quadrant_ = quadrant_ahead(arc.at_);
    const int last = quadrant_behind(arc.end_);
    arc.quadrants_left_ = (last - arc.quadrant_ + kQuadrants) % kQuadrants;
    if (arc.quadrants_left_ == 0 && !lies_ahead(arc.at_, arc.end_, kDirections[arc.quadrant_])) {
        arc.quadrants_left_ = kQuadrants;
    }
    return arc;
}

Point PointByPoint::at() const noexcept {
    return {at_.x * x_sign_, at_.y * y_sign_};
}

bool PointByPoint::passes(int x, int y) const noexcept {
    // Quadrant n ends at the circle's end n: up, left, down, right, seen counter-clockwise.
    const int end = y != 0 ? (y * y_sign_ > 0 ? 0 : 2) : (x < 0 ? 1 : 3);
    return (end - quadrant_ + kQuadrants) % kQuadrants < quadrants_left_;
}

Step PointByPoint::directions() const noexcept {
    if (!is_arc_) return {1, 1};
    // An end a little off the circle may lie where the quadrant does not lead: back to it, once the other
    // axis has arrived.
    if (quadrants_left_ == 0 && at_.x == end_.x) return {0, end_.y < at_.y ? -1 : 1};
    if (quadrants_left_ == 0 && at_.y == end_.y) return {end_.x < at_.x ? -1 : 1, 0};
    return kDirections[quadrant_];
}

bool PointByPoint::leads_x() const noexcept {
    // Where one axis has arrived the other goes on alone.
    if (quadrants_left_ == 0 && at_.x == end_.x) return false;
    if (quadrants_left_ == 0 && at_.y == end_.y) return true;
    const bool x_leads_inwards = !is_arc_ || quadrant_ % 2 == 0;
    return (deviation_ >= 0) == x_leads_inwards;
}

Step PointByPoint::next() noexcept {
    const Step directions = this->directions();
    Step step{};
    if (leads_x()) {
        step.x = directions.x;
        deviation_ += is_arc_ ? 2 * at_.x * step.x + 1 : -end_.y;
        at_.x += step.x;
    } else {
        step.y = directions.y;
        deviation_ += is_arc_ ? 2 * at_.y * step.y + 1 : end_.x;
        at_.y += step.y;
    }
    if (is_arc_ && quadrants_left_ > 0) enter_next_quadrant();
    return {step.x * x_sign_, step.y * y_sign_};
}

// In quadrants 0 and 2 x runs down to its zero, in 1 and 3 y does.
void PointByPoint::enter_next_quadrant() noexcept {
    if ((quadrant_ % 2 == 0 ? at_.x : at_.y) != 0) return;
    quadrant_ = (quadrant_ + 1) % kQuadrants;
    --quadrants_left_;
}

}  // namespace psicarve::cycle
