// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "hmi/flat/dxf_shapes.hpp"

namespace psicarve::flat {
namespace {

// Far points have no effect: each one further takes off three quarters of the rest.
constexpr std::size_t kFeltPoints = 30;

struct FitPoints {
    std::vector<Point> points;
    std::optional<Point> first_slope;  ///< a direction; none: it runs out straight
    std::optional<Point> last_slope;
};

Point scaled(Point p, double factor) noexcept {
    return {p.x * factor, p.y * factor};
}
Point sum_of(Point a, Point b) noexcept {
    return {a.x + b.x, a.y + b.y};
}
double apart(Point a, Point b) noexcept {
    return std::hypot(b.x - a.x, b.y - a.y);
}

/// Slopes at the points of the cubic spline whose parameter is the chords' length: continuous to the second
/// derivative, solved from the first point to the last and back (Thomas).
std::vector<Point> slopes_of(const FitPoints& fit) {
    const std::vector<Point>& p = fit.points;
    const std::size_t last = p.size() - 1;
    std::vector<Point> slopes(p.size());
    std::vector<double> above(p.size(), 0.0);
    const auto direction = [](Point d) { return scaled(d, 1.0 / std::max(std::hypot(d.x, d.y), 1e-300)); };
    const auto chord = [&p](std::size_t i) {
        const double length = apart(p[i], p[i + 1]);
        return Point{(p[i + 1].x - p[i].x) / length, (p[i + 1].y - p[i].y) / length};
    };
    if (fit.first_slope) {
        slopes[0] = direction(*fit.first_slope);
    } else {
        above[0] = 0.5;
        slopes[0] = scaled(chord(0), 1.5);
    }
    for (std::size_t i = 1; i < last; ++i) {
        const double before = apart(p[i - 1], p[i]);
        const double after = apart(p[i], p[i + 1]);
        const double pivot = 2.0 * (before + after) - after * above[i - 1];
        above[i] = before / pivot;
        const Point wanted = sum_of(scaled(chord(i - 1), 3.0 * after), scaled(chord(i), 3.0 * before));
        slopes[i] = scaled(sum_of(wanted, scaled(slopes[i - 1], -after)), 1.0 / pivot);
    }
    if (fit.last_slope) {
        slopes[last] = direction(*fit.last_slope);
    } else {
        const Point wanted = scaled(chord(last - 1), 3.0);
        slopes[last] = scaled(sum_of(wanted, scaled(slopes[last - 1], -1.0)), 1.0 / (2.0 - above[last - 1]));
    }
    for (std::size_t i = last; i-- > 0;) slopes[i] = sum_of(slopes[i], scaled(slopes[i + 1], -above[i]));
    return slopes;
}

FitPoints fit_points_of(const DxfElement& element) {
    FitPoints fit;
    std::vector<Point> all;
    for (const DxfGroup& group : element.groups) {
        const DxfElement one{{}, 0, 0, {group}};
        if (group.code == 11) all.push_back({one.number(11, 0.0), 0.0});
        if (group.code == 21 && !all.empty()) all.back().y = one.number(21, 0.0);
    }
    for (const Point& p : all) {
        if (fit.points.empty() || apart(fit.points.back(), p) > 0.0) fit.points.push_back(p);
    }
    const Point first = element.point(12);
    const Point last = element.point(13);
    if (std::hypot(first.x, first.y) > 0.0) fit.first_slope = first;
    if (std::hypot(last.x, last.y) > 0.0) fit.last_slope = last;
    return fit;
}

}  // namespace

bool draw_dxf_fit_spline(const DxfElement& element, const Affine& placement, PathMaker& maker) {
    FitPoints fit = fit_points_of(element);
    const bool is_closed = (element.whole(70, 0) & 1) != 0;
    if (is_closed && fit.points.size() > 1 && apart(fit.points.front(), fit.points.back()) == 0.0)
        fit.points.pop_back();
    const std::size_t count = fit.points.size();
    if (count < 2) return false;
    std::size_t begin = 0;
    std::size_t end = count - 1;
    if (is_closed) {
        // With more of the round added on both sides, the ends have no effect on the drawn part.
        const std::vector<Point> once = fit.points;
        fit = {};
        for (std::size_t i = 0; i <= count + 2 * kFeltPoints; ++i)
            fit.points.push_back(once[(i + count * kFeltPoints - kFeltPoints) % count]);
        begin = kFeltPoints;
        end = kFeltPoints + count;
    }
    const std::vector<Point> slopes = slopes_of(fit);
    maker.place(placement);
    maker.move_to(fit.points[begin]);
    for (std::size_t i = begin; i < end; ++i) {
        const Point from = fit.points[i];
        const Point to = fit.points[i + 1];
        const double third = apart(from, to) / 3.0;
        maker.cubic_to(sum_of(from, scaled(slopes[i], third)), sum_of(to, scaled(slopes[i + 1], -third)), to);
    }
    if (is_closed) maker.close();
    maker.end();
    return true;
}

}  // namespace psicarve::flat
