// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

constexpr double kMostPieces = 10'000.0;  // of one curve
constexpr double kSamePlace_mm = 1e-9;    // the rounding of one point

Point plus(Point a, Point b) noexcept {
    return {a.x + b.x, a.y + b.y};
}
Point times(Point a, double factor) noexcept {
    return {a.x * factor, a.y * factor};
}

bool is_same(Point a, Point b) noexcept {
    return std::abs(a.x - b.x) <= kSamePlace_mm && std::abs(a.y - b.y) <= kSamePlace_mm;
}

/// Pieces of a cubic: a chord over 1/n of the parameter is away from it by at most max|B''| / (8 n^2).
int cubic_pieces(Point p0, Point p1, Point p2, Point p3) noexcept {
    const double first = std::hypot(p0.x - 2.0 * p1.x + p2.x, p0.y - 2.0 * p1.y + p2.y);
    const double second = std::hypot(p1.x - 2.0 * p2.x + p3.x, p1.y - 2.0 * p2.y + p3.y);
    const double pieces = std::ceil(std::sqrt(6.0 * std::max(first, second) / (8.0 * kFlatness_mm)));
    return static_cast<int>(std::clamp(pieces, 1.0, kMostPieces));
}

int ellipse_pieces(double radius_mm, double sweep_rad) noexcept {
    if (!(radius_mm > kFlatness_mm)) return 1;
    const double step_rad = 2.0 * std::acos(1.0 - kFlatness_mm / radius_mm);
    return static_cast<int>(std::clamp(std::ceil(std::abs(sweep_rad) / step_rad), 1.0, kMostPieces));
}

double length_of(const Path& path) noexcept {
    double length_mm = 0.0;
    const std::size_t count = path.points.size();
    for (std::size_t i = 0; i + (path.is_closed ? 0 : 1) < count; ++i) {
        const Point a = path.points[i];
        const Point b = path.points[(i + 1) % count];
        length_mm += std::hypot(b.x - a.x, b.y - a.y);
    }
    return length_mm;
}

}  // namespace

Affine after(const Affine& outer, const Affine& inner) noexcept {
    const Point x = outer.turn({inner.a, inner.b});
    const Point y = outer.turn({inner.c, inner.d});
    const Point o = outer.apply({inner.e, inner.f});
    return {x.x, x.y, y.x, y.y, o.x, o.y};
}

void PathMaker::add(Point placed) {
    if (!std::isfinite(placed.x) || !std::isfinite(placed.y)) is_not_finite_ = true;
    if (count_ >= kMostDrawingPoints) is_spent_ = true;
    if (is_not_finite_ || is_spent_) return;
    if (!points_.empty() && is_same(points_.back(), placed)) return;
    points_.push_back(placed);
    ++count_;
}

void PathMaker::placed_point(Point point) {
    add(point);
}

void PathMaker::finish(bool is_closed) {
    if (is_closed && points_.size() > 1 && is_same(points_.front(), points_.back())) points_.pop_back();
    if (points_.size() > 1)
        paths_.push_back({std::move(points_), is_closed, is_filled_, width_mm_, is_shown_, {}});
    points_.clear();
}

void PathMaker::move_to(Point to) {
    finish(false);
    pen_ = start_ = to;
}

void PathMaker::end() {
    finish(false);
}

void PathMaker::close() {
    finish(true);
    pen_ = start_;
}

void PathMaker::line_to(Point to) {
    add(placement_.apply(pen_));
    add(placement_.apply(to));
    pen_ = to;
}

void PathMaker::quadratic_to(Point control, Point to) {
    const auto third = [](Point near, Point far) {
        return Point{near.x + 2.0 / 3.0 * (far.x - near.x), near.y + 2.0 / 3.0 * (far.y - near.y)};
    };
    cubic_to(third(pen_, control), third(to, control), to);
}

void PathMaker::cubic_to(Point control_1, Point control_2, Point to) {
    const Point p0 = placement_.apply(pen_);
    const Point p1 = placement_.apply(control_1);
    const Point p2 = placement_.apply(control_2);
    const Point p3 = placement_.apply(to);
    add(p0);
    const int pieces = cubic_pieces(p0, p1, p2, p3);
    for (int i = 1; i < pieces && !is_spent_; ++i) {
        const double t = static_cast<double>(i) / pieces;
        const double s = 1.0 - t;
        add(plus(plus(times(p0, s * s * s), times(p1, 3.0 * s * s * t)),
                 plus(times(p2, 3.0 * s * t * t), times(p3, t * t * t))));
    }
    add(p3);
    pen_ = to;
}

void PathMaker::ellipse(Point centre, Point u, Point v, double from_rad, double sweep_rad) {
    const Point c = placement_.apply(centre);
    const Point pu = placement_.turn(u);
    const Point pv = placement_.turn(v);
    const auto at = [&](double t) { return plus(c, plus(times(pu, std::cos(t)), times(pv, std::sin(t)))); };
    // |u cos t + v sin t| is never more than this.
    const int pieces = ellipse_pieces(std::hypot(std::hypot(pu.x, pu.y), std::hypot(pv.x, pv.y)), sweep_rad);
    for (int i = 0; i <= pieces && !is_spent_; ++i) {
        add(at(from_rad + sweep_rad * static_cast<double>(i) / pieces));
    }
    const double end_rad = from_rad + sweep_rad;
    pen_ = plus(centre, plus(times(u, std::cos(end_rad)), times(v, std::sin(end_rad))));
}

// Source: SVG 1.1, appendix F.6, from end points to centre.
void PathMaker::arc_to(double radius_x, double radius_y, double turn_rad, bool is_large, bool is_positive,
                       Point to) {
    double rx = std::abs(radius_x);
    double ry = std::abs(radius_y);
    if (pen_ == to) return;
    if (!(rx > 0.0) || !(ry > 0.0)) return line_to(to);
    const double cosine = std::cos(turn_rad);
    const double sine = std::sin(turn_rad);
    const Point half{0.5 * (pen_.x - to.x), 0.5 * (pen_.y - to.y)};
    const Point p{(cosine * half.x + sine * half.y) / rx, (cosine * half.y - sine * half.x) / ry};
    double share = p.x * p.x + p.y * p.y;
    if (share > 1.0) {  // too small to reach: just large enough now
        rx *= std::sqrt(share);
        ry *= std::sqrt(share);
    }
    const double grown = std::sqrt(std::max(share, 1.0));
    const Point q{p.x / grown, p.y / grown};
    share = q.x * q.x + q.y * q.y;
    double factor = share > 0.0 ? std::sqrt(std::max(0.0, 1.0 / share - 1.0)) : 0.0;
    if (is_large == is_positive) factor = -factor;
    const Point c{factor * q.y, -factor * q.x};  // centre, where the ellipse is the unit circle
    const Point centre{cosine * rx * c.x - sine * ry * c.y + 0.5 * (pen_.x + to.x),
                       sine * rx * c.x + cosine * ry * c.y + 0.5 * (pen_.y + to.y)};
    const double from_rad = std::atan2(q.y - c.y, q.x - c.x);
    double sweep_rad = std::atan2(-q.y - c.y, -q.x - c.x) - from_rad;
    if (is_positive && sweep_rad < 0.0) sweep_rad += 2.0 * kPi;
    if (!is_positive && sweep_rad > 0.0) sweep_rad -= 2.0 * kPi;
    ellipse(centre, {cosine * rx, sine * rx}, {-sine * ry, cosine * ry}, from_rad, sweep_rad);
    // The end is exactly where it was asked for.
    if (!points_.empty()) points_.back() = placement_.apply(to);
    pen_ = to;
}

Result<void> PathMaker::check(const std::string& file) const {
    if (is_not_finite_) return bad_input(file + ": a coordinate is not a finite number");
    if (is_spent_) return too_many_points(file);
    return {};
}

Error too_many_points(const std::string& file) {
    return bad_input(file + ": more than " + std::to_string(kMostDrawingPoints) +
                     " points when its curves are cut into straight pieces; nobody can carve that");
}

std::string why_without_lines(const Drawing& drawing) {
    const auto tells =
        std::find_if(drawing.warnings.begin(), drawing.warnings.end(),
                     [](const std::string& said) { return !said.starts_with("the drawing does not say"); });
    return tells == drawing.warnings.end() ? std::string{} : ": " + *tells;
}

void PathMaker::dash(std::size_t first_path, const Dashes& dashes, double in_length) {
    double factor = 1.0;
    if (in_length > 0.0) {
        double length_mm = 0.0;
        for (std::size_t i = first_path; i < paths_.size(); ++i) length_mm += length_of(paths_[i]);
        factor = length_mm / in_length;
    }
    Dashes made = dashes;
    for (double& length : made.lengths_mm) length *= factor;
    made.offset_mm *= factor;
    const double whole_mm = std::accumulate(made.lengths_mm.begin(), made.lengths_mm.end(), 0.0);
    if (!(whole_mm > 0.0) || !std::isfinite(whole_mm) || !std::isfinite(made.offset_mm)) return;
    for (std::size_t i = first_path; i < paths_.size(); ++i) paths_[i].dashes = made;
}

bool box_of(const std::vector<Path>& paths, Point& least, Point& most) {
    constexpr double kFar = std::numeric_limits<double>::max();
    least = {kFar, kFar};
    most = {-kFar, -kFar};
    for (const Path& path : paths) {
        for (const Point& p : path.points) {
            least = {std::min(least.x, p.x), std::min(least.y, p.y)};
            most = {std::max(most.x, p.x), std::max(most.y, p.y)};
        }
    }
    return least.x <= most.x;
}

}  // namespace psicarve::flat
