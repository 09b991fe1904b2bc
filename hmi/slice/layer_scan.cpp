// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/layer_scan.hpp"

#include <emmintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/placement.hpp"

namespace psicarve::slice {
namespace {

constexpr std::uint32_t kOutside = 1U;        // a wall seen from outside
constexpr std::uint32_t kInside = 1U << 16U;  // a wall seen from inside
// Segments narrower than this (quarter turns) are computed along the segment: the quotient of spec 2 loses
// its digits where segment and direction are nearly parallel.
constexpr double kNarrow = 1e-7;

/// The two edges a facet is cut at, each with its lower vertex, in the order that has the solid on the left.
struct CutEdges {
    std::uint8_t p_low;
    std::uint8_t p_high;
    std::uint8_t q_low;
    std::uint8_t q_high;
};
// By which vertices lie above the cut, bit n for vertex n: one vertex is alone on its side, and both edges
// meet there. A table, since facets come in every order and branches would be guesses. 0 and 7 cannot be.
constexpr std::array<CutEdges, 8> kCutEdges{{{0, 0, 0, 0},
                                             {1, 0, 2, 0},
                                             {2, 1, 0, 1},
                                             {2, 1, 2, 0},
                                             {0, 2, 1, 2},
                                             {1, 0, 1, 2},
                                             {0, 2, 0, 1},
                                             {0, 0, 0, 0}}};

/// diamond_angle of both ends at once and without a branch: ends come from everywhere.
std::array<double, 2> diamond_angles(const SectionSegment& segment) noexcept {
    const __m128d p = _mm_set_pd(segment.py, segment.px);
    const __m128d q = _mm_set_pd(segment.qy, segment.qx);
    const __m128d x = _mm_unpacklo_pd(p, q);
    const __m128d y = _mm_unpackhi_pd(p, q);
    const __m128d sign = _mm_set1_pd(-0.0);
    const __m128d not_zero = _mm_set1_pd(1e-300);
    const __m128d sum = _mm_add_pd(_mm_add_pd(_mm_andnot_pd(sign, x), _mm_andnot_pd(sign, y)), not_zero);
    const __m128d slope = _mm_div_pd(y, sum);
    const __m128d is_left = _mm_cmplt_pd(x, _mm_setzero_pd());
    const __m128d is_below = _mm_cmplt_pd(slope, _mm_setzero_pd());
    const __m128d begin = _mm_or_pd(_mm_and_pd(is_left, _mm_set1_pd(2.0)),
                                    _mm_andnot_pd(is_left, _mm_and_pd(is_below, _mm_set1_pd(4.0))));
    std::array<double, 2> angles{};
    _mm_storeu_pd(angles.data(), _mm_add_pd(begin, _mm_xor_pd(slope, _mm_and_pd(is_left, sign))));
    return angles;
}

}  // namespace

SectionSegment FacetCutter::cut(const model::Triangle& facet, double z) const noexcept {
    const auto& v = facet.vertices;
    const std::size_t up = from_[2];
    const auto above = [z](float vertex_z) { return z < double{vertex_z} ? 1U : 0U; };
    const CutEdges& edges = kCutEdges[above(v[0][up]) + 2 * above(v[1][up]) + 4 * above(v[2][up])];
    const auto point = [&](const std::array<float, 3>& low, const std::array<float, 3>& high, double& x,
                           double& y) {
        const double part = (z - low[up]) / (double{high[up]} - low[up]);
        const double low_x = low[from_[0]] - shift_x_;
        const double low_y = low[from_[1]] - shift_y_;
        x = low_x + part * ((high[from_[0]] - shift_x_) - low_x);
        y = low_y + part * ((high[from_[1]] - shift_y_) - low_y);
    };
    SectionSegment s{};
    point(v[edges.p_low], v[edges.p_high], s.px, s.py);
    point(v[edges.q_low], v[edges.q_high], s.qx, s.qy);
    return s;
}

/// A wall with its ends in ascending order of angle.
struct LayerScan::Wall {
    double px;
    double py;
    double dx;  ///< Q - P
    double dy;
    std::uint32_t count;  ///< kOutside or kInside
};

/// A wall with its cells: [from, to), or, where it passes angle 0, [from, end) and [0, to).
struct LayerScan::SeenWall {
    Wall wall;
    std::uint32_t from;
    std::uint32_t to;
    bool wraps;
    bool is_narrow;
};

LayerScan::LayerScan(const Directions& directions)
    : directions_(directions),
      outer_(directions.count(), 0.0),
      walls_(directions.count(), 0U),
      result_(directions.count(), 0.0),
      result_walls_(directions.count(), 0U) {}

void LayerScan::draw(const Wall& s, std::uint32_t first, std::uint32_t end) noexcept {
    const double* cosine = directions_.cosine();
    const double* sine = directions_.sine();
    const double across = s.px * s.dy - s.py * s.dx;  // = Px*Qy - Py*Qx
    double sum = 0.0;
    for (std::uint32_t k = first; k < end; ++k) {
        const double radius = across / (cosine[k] * s.dy - sine[k] * s.dx);
        outer_[k] = std::max(outer_[k], radius);
        walls_[k] += s.count;
        sum += radius;
    }
    radius_sum_ += sum;
}

void LayerScan::draw_radial(const Wall& s, std::uint32_t first, std::uint32_t end) noexcept {
    for (std::uint32_t k = first; k < end; ++k) {
        const double c = directions_.cosine()[k];
        const double n = directions_.sine()[k];
        const double p_aside = c * s.py - n * s.px;
        const double q_aside = c * (s.py + s.dy) - n * (s.px + s.dx);
        const double part = p_aside == q_aside ? 1.0 : std::clamp(p_aside / (p_aside - q_aside), 0.0, 1.0);
        const double radius = std::hypot(s.px + part * s.dx, s.py + part * s.dy);
        outer_[k] = std::max(outer_[k], radius);
        walls_[k] += s.count;
        radius_sum_ += radius;
    }
}

/// Diamond angles of a segment's ends, and the cells at which they lie.
struct LayerScan::Ends {
    double p_angle;
    double q_angle;
    std::uint32_t p_cell;
    std::uint32_t q_cell;
};

LayerScan::Ends LayerScan::ends_of(const SectionSegment& segment) const noexcept {
    const auto [p_angle, q_angle] = diamond_angles(segment);
    return {p_angle, q_angle, directions_.count_up_to(p_angle), directions_.count_up_to(q_angle)};
}

bool LayerScan::see(const SectionSegment& segment, const Ends& ends, SeenWall& seen) noexcept {
    const auto& [px, py, qx, qy] = segment;
    const auto& [p_angle, q_angle, p_cell, q_cell] = ends;
    // The short way round is the way the segment goes: opposite directions are exactly 2 apart.
    const double turn = q_angle - p_angle;
    seen.wraps = std::abs(turn) > 2.0;
    // If there are so few directions, a segment passes all of them round by angle 0 from a cell to the same
    // one.
    if (p_cell == q_cell && !seen.wraps) return false;
    const bool counter_clockwise = (turn > 0.0) != seen.wraps;
    seen.wall = {px, py, qx - px, qy - py, counter_clockwise ? kOutside : kInside};
    seen.from = counter_clockwise ? p_cell : q_cell;
    seen.to = counter_clockwise ? q_cell : p_cell;
    seen.is_narrow = (seen.wraps ? 4.0 - std::abs(turn) : std::abs(turn)) < kNarrow;
    return true;
}

void LayerScan::add_segment(const SectionSegment& segment) noexcept {
    SeenWall seen;
    if (see(segment, ends_of(segment), seen)) draw(seen);
}

void LayerScan::add_segments(std::span<const SectionSegment> segments) noexcept {
    std::array<Ends, kMostAtOnce> ends;
    for (std::size_t i = 0; i < segments.size(); ++i) ends[i] = ends_of(segments[i]);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        SeenWall seen;
        if (see(segments[i], ends[i], seen)) draw(seen);
    }
}

void LayerScan::draw(const SeenWall& seen) noexcept {
    const auto paint = [&](std::uint32_t first, std::uint32_t end) {
        if (seen.is_narrow) {
            draw_radial(seen.wall, first, end);
        } else {
            draw(seen.wall, first, end);
        }
    };
    if (!seen.wraps) {
        paint(seen.from, seen.to);
    } else {
        paint(seen.from, static_cast<std::uint32_t>(directions_.count()));
        paint(0, seen.to);
    }
}

void LayerScan::add_segment_in(const SectionSegment& segment, std::uint32_t cell) noexcept {
    SeenWall seen;
    if (!see(segment, ends_of(segment), seen)) return;
    const bool is_after = cell >= seen.from;
    const bool is_before = cell < seen.to;
    if (seen.wraps ? !is_after && !is_before : !is_after || !is_before) return;
    if (seen.is_narrow) {
        draw_radial(seen.wall, cell, cell + 1);
    } else {
        draw(seen.wall, cell, cell + 1);
    }
}

const LayerTotals& LayerScan::finish() noexcept {
    LayerTotals totals;
    const std::size_t count = walls_.size();
    const std::size_t first = directions_.first_sorted();
    std::uint32_t odd = 0;
    std::uint32_t inside = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint32_t outsides = walls_[k] & 0xFFFFU;
        const std::uint32_t insides = walls_[k] >> 16U;
        const std::uint32_t walls = outsides + insides;
        odd += walls & 1U;
        totals.walls += walls;
        totals.empty_cells += walls == 0 ? 1 : 0;
        totals.hidden_walls += walls > 1 ? walls - 1 : 0;
        const std::uint32_t excess = outsides - insides;
        // Of overlapping solids that share the axis two walls lead out and none in. An odd count alone shows
        // that, too, whichever way its facets look.
        inside += excess != 0 ? 1 : 0;
        totals.turned_cells += excess > 1 ? 1 : 0;
        totals.outer_sum += outer_[k];
        totals.radius_max = std::max(totals.radius_max, outer_[k]);
        std::size_t to = k + first;
        if (to >= count) to -= count;
        result_[to] = outer_[k];
        result_walls_[to] = walls;
    }
    totals.has_section = totals.walls > 0;
    totals.contains_axis = 2 * inside > count;
    totals.is_odd = 2 * odd > count;
    totals.open_cells = totals.is_odd ? static_cast<std::uint32_t>(count) - odd : odd;
    totals.radius_sum = radius_sum_;
    totals_ = totals;
    std::fill(outer_.begin(), outer_.end(), 0.0);
    std::fill(walls_.begin(), walls_.end(), 0U);
    radius_sum_ = 0.0;
    return totals_;
}

}  // namespace psicarve::slice
