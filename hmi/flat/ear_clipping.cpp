// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/ear_clipping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace psicarve::flat {
namespace {

double twice_area(Point a, Point b, Point c) noexcept {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Corners that turn inwards, in squares: only they can lie in an ear.
class ReflexGrid {
public:
    ReflexGrid(const std::vector<Point>& ring, const std::vector<bool>& is_reflex) : ring_(ring) {
        const Path whole{ring, true, false};
        Point most;
        box_of({whole}, least_, most);
        const auto count = static_cast<double>(std::count(is_reflex.begin(), is_reflex.end(), true));
        side_ = static_cast<std::size_t>(std::clamp(std::sqrt(count), 1.0, 1000.0));
        width_ = std::max({(most.x - least_.x), (most.y - least_.y), 1e-12}) / static_cast<double>(side_);
        cells_.resize(side_ * side_);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            if (is_reflex[i])
                cells_[cell(ring[i].y, least_.y) * side_ + cell(ring[i].x, least_.x)].push_back(i);
        }
    }

    /// Whether a corner other than the ear's own lies in it. Corners that are no longer reflex, or were cut
    /// off, are dropped on the way.
    bool any_inside(std::size_t a, std::size_t b, std::size_t c, const std::vector<bool>& is_reflex) {
        const Point &p = ring_[a], &q = ring_[b], &r = ring_[c];
        const std::size_t x_end = cell(std::max({p.x, q.x, r.x}), least_.x);
        const std::size_t y_end = cell(std::max({p.y, q.y, r.y}), least_.y);
        for (std::size_t y = cell(std::min({p.y, q.y, r.y}), least_.y); y <= y_end; ++y) {
            for (std::size_t x = cell(std::min({p.x, q.x, r.x}), least_.x); x <= x_end; ++x) {
                auto& corners = cells_[y * side_ + x];
                std::erase_if(corners, [&](std::size_t i) { return !is_reflex[i]; });
                const bool found = std::any_of(corners.begin(), corners.end(), [&](std::size_t i) {
                    const Point& s = ring_[i];
                    if (s == p || s == q || s == r) return false;
                    return twice_area(p, q, s) >= 0.0 && twice_area(q, r, s) >= 0.0 &&
                           twice_area(r, p, s) >= 0.0;
                });
                if (found) return true;
            }
        }
        return false;
    }

private:
    std::size_t cell(double value, double least) const noexcept {
        return static_cast<std::size_t>(
            std::clamp((value - least) / width_, 0.0, static_cast<double>(side_) - 1.0));
    }

    const std::vector<Point>& ring_;
    Point least_;
    double width_ = 1.0;
    std::size_t side_ = 1;
    std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> triangles_of(const std::vector<Point>& ring) {
    const std::size_t n = ring.size();
    std::vector<std::array<std::size_t, 3>> triangles;
    if (n < 3) return triangles;
    std::vector<std::size_t> before(n);
    std::vector<std::size_t> behind(n);
    for (std::size_t i = 0; i < n; ++i) {
        before[i] = (i + n - 1) % n;
        behind[i] = (i + 1) % n;
    }
    const auto turn = [&](std::size_t i) { return twice_area(ring[before[i]], ring[i], ring[behind[i]]); };
    std::vector<bool> is_reflex(n);
    for (std::size_t i = 0; i < n; ++i) is_reflex[i] = turn(i) <= 0.0;
    ReflexGrid reflex(ring, is_reflex);

    std::size_t left = n;
    std::size_t passed = 0;  // corners in a row that are no ear
    for (std::size_t i = 0; left > 3;) {
        // Once round without an ear: rounding has spoilt the ring, and any convex corner must do.
        const bool is_ear =
            turn(i) > 0.0 && (passed >= left || !reflex.any_inside(before[i], i, behind[i], is_reflex));
        if (!is_ear && passed < 2 * left) {
            ++passed;
            i = behind[i];
            continue;
        }
        triangles.push_back({before[i], i, behind[i]});
        const std::size_t a = before[i];
        const std::size_t b = behind[i];
        behind[a] = b;
        before[b] = a;
        is_reflex[i] = false;
        for (const std::size_t corner : {a, b}) is_reflex[corner] = is_reflex[corner] && turn(corner) <= 0.0;
        passed = 0;
        --left;
        i = behind[b];  // not the next one: fans of slivers otherwise
        if (left == 3) triangles.push_back({before[b], b, behind[b]});
    }
    if (n == 3) triangles.push_back({0, 1, 2});
    return triangles;
}

}  // namespace psicarve::flat
