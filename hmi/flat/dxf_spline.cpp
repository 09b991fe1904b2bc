// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hmi/flat/dxf_shapes.hpp"

namespace psicarve::flat {
namespace {

constexpr std::size_t kMostDegree = 25;
constexpr int kDeepestCut = 12;
constexpr int kLeastCut = 2;  // a piece that bends both ways may meet its chord in the middle

/// A point times its weight, and the weight.
struct Weighted {
    double x = 0.0;
    double y = 0.0;
    double w = 0.0;
};

class Spline {
public:
    std::size_t degree = 3;
    std::vector<double> knots;
    std::vector<Weighted> points;

    bool is_good() const {
        if (degree < 1 || degree > kMostDegree || points.size() <= degree) return false;
        if (knots.size() != points.size() + degree + 1) return false;
        if (!std::is_sorted(knots.begin(), knots.end()) || !(knots[degree] < knots[points.size()]))
            return false;
        return std::all_of(points.begin(), points.end(), [](const Weighted& p) { return p.w > 0.0; });
    }

    /// De Boor's algorithm within the knot span that begins at knots[span].
    Point at(std::size_t span, double t) const {
        std::array<Weighted, kMostDegree + 1> d{};
        for (std::size_t j = 0; j <= degree; ++j) d[j] = points[span - degree + j];
        for (std::size_t r = 1; r <= degree; ++r) {
            for (std::size_t j = degree; j >= r; --j) {
                const double low = knots[span - degree + j];
                const double width = knots[span + 1 + j - r] - low;
                const double share = width > 0.0 ? (t - low) / width : 0.0;
                const Weighted &a = d[j - 1], &b = d[j];
                d[j] = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.w + share * (b.w - a.w)};
            }
        }
        return {d[degree].x / d[degree].w, d[degree].y / d[degree].w};
    }
};

double away_from_chord(Point p, Point a, Point b) noexcept {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0.0)) return std::hypot(p.x - a.x, p.y - a.y);
    return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
}

class SplinePen {
public:
    SplinePen(const Spline& spline, const Affine& placement, PathMaker& maker)
        : spline_(spline), placement_(placement), maker_(maker) {}

    void draw() {
        for (std::size_t span = spline_.degree; span < spline_.points.size(); ++span) {
            const double from = spline_.knots[span];
            const double to = spline_.knots[span + 1];
            if (!(from < to) || maker_.is_over()) continue;
            const Point first = placed(span, from);
            maker_.placed_point(first);
            cut(span, from, first, to, placed(span, to), 0);
        }
    }

private:
    Point placed(std::size_t span, double t) const { return placement_.apply(spline_.at(span, t)); }

    void cut(std::size_t span, double from, Point first, double to, Point last, int depth) {
        const double middle = 0.5 * (from + to);
        const Point half = placed(span, middle);
        const double away = std::max({away_from_chord(half, first, last),
                                      away_from_chord(placed(span, 0.5 * (from + middle)), first, last),
                                      away_from_chord(placed(span, 0.5 * (middle + to)), first, last)});
        if (depth < kLeastCut || (away > kFlatness_mm && depth < kDeepestCut)) {
            cut(span, from, first, middle, half, depth + 1);
            cut(span, middle, half, to, last, depth + 1);
        } else {
            maker_.placed_point(last);
        }
    }

    const Spline& spline_;
    Affine placement_;
    PathMaker& maker_;
};

}  // namespace

bool draw_dxf_spline(const DxfElement& element, const Affine& placement, PathMaker& maker) {
    Spline spline;
    std::vector<double> weights;
    for (const DxfGroup& group : element.groups) {
        const DxfElement one{{}, 0, 0, {group}};
        if (group.code == 40) spline.knots.push_back(one.number(40, 0.0));
        if (group.code == 41) weights.push_back(one.number(41, 1.0));
        if (group.code == 10) spline.points.push_back({one.number(10, 0.0), 0.0, 1.0});
        if (group.code == 20 && !spline.points.empty()) spline.points.back().y = one.number(20, 0.0);
    }
    const int degree = element.whole(71, 3);
    spline.degree = degree < 0 ? 0 : static_cast<std::size_t>(degree);
    if (!weights.empty() && weights.size() != spline.points.size()) return false;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        Weighted& p = spline.points[i];
        p = {p.x * weights[i], p.y * weights[i], weights[i]};
    }
    if (!spline.is_good()) return false;
    maker.place(placement);
    maker.move_to({});
    SplinePen(spline, placement, maker).draw();
    maker.end();
    return true;
}

}  // namespace psicarve::flat
