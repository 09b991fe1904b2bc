// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/stroke_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace psicarve::flat {
namespace {

constexpr double kMostCells = 100'000.0;
// Of strokes cut at cells: a drawing full of long lines gets larger ones.
constexpr double kMostPieces = 5e6;
// A longer piece might be nearer the other way round.
constexpr double kLongestShareOfRound = 0.125;

double distance2(Point p, Point from, Point to) noexcept {
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double length2 = x * x + y * y;
    const double along = length2 > 0.0 ? ((p.x - from.x) * x + (p.y - from.y) * y) / length2 : 0.0;
    const double share = std::clamp(along, 0.0, 1.0);
    const double away_x = p.x - from.x - share * x;
    const double away_y = p.y - from.y - share * y;
    return away_x * away_x + away_y * away_y;
}

/// The part of from + t (to - from), 0 <= t <= 1, where |coordinate| <= half; cuts `first` and `last` down to
/// it.
void cut_to_slab(double from, double to, double half, double& first, double& last) noexcept {
    const double way = to - from;
    if (way == 0.0) {
        if (std::abs(from) > half) last = -1.0;
        return;
    }
    const double enters = (std::copysign(half, -way) - from) / way;
    const double leaves = (std::copysign(half, way) - from) / way;
    first = std::max(first, enters);
    last = std::min(last, leaves);
}

double away2_of_end(Point p, const HalfCell& half) noexcept {
    const double x = std::max(0.0, std::abs(p.x) - half.along_mm);
    const double y = std::max(0.0, std::abs(p.y) - half.height_mm);
    return x * x + y * y;
}

/// Between the cell round `p` and the piece; 0 where it passes through.
double distance2(Point p, const HalfCell& half, Point from, Point to) noexcept {
    const Point a{from.x - p.x, from.y - p.y};
    const Point b{to.x - p.x, to.y - p.y};
    double first = 0.0;
    double last = 1.0;
    cut_to_slab(a.x, b.x, half.along_mm, first, last);
    cut_to_slab(a.y, b.y, half.height_mm, first, last);
    if (first <= last) return 0.0;
    double least = std::min(away2_of_end(a, half), away2_of_end(b, half));
    for (const double x : {-half.along_mm, half.along_mm}) {
        for (const double y : {-half.height_mm, half.height_mm})
            least = std::min(least, distance2({x, y}, a, b));
    }
    return least;
}

/// A stroke's straight parts, with the one that closes it.
template <typename Part>
void for_each_part(const GrooveStroke& stroke, const Part& part) {
    const std::size_t count = stroke.points.size();
    for (std::size_t i = 0; i + (stroke.is_closed ? 0 : 1) < count; ++i)
        part(stroke.points[i], stroke.points[(i + 1) % count]);
}

double length_mm(const Grooves& grooves) {
    double sum_mm = 0.0;
    for (const GrooveStroke& stroke : grooves.strokes) {
        for_each_part(stroke,
                      [&](Point from, Point to) { sum_mm += std::hypot(to.x - from.x, to.y - from.y); });
    }
    return sum_mm;
}

}  // namespace

StrokeIndex::StrokeIndex(const Grooves& grooves, double reach_mm)
    : round_mm_(grooves.round_mm()), reach_mm_(reach_mm) {
    const double cell_mm =
        std::max({reach_mm + grooves.widest_floor_mm(), std::sqrt(round_mm_ * grooves.height_mm / kMostCells),
                  round_mm_ / kMostCells, length_mm(grooves) / kMostPieces});
    columns_ = static_cast<std::size_t>(std::max(1.0, std::floor(round_mm_ / cell_mm)));
    rows_ = static_cast<std::size_t>(std::max(1.0, std::floor(grooves.height_mm / cell_mm)));
    cell_x_mm_ = round_mm_ / static_cast<double>(columns_);
    cell_y_mm_ = grooves.height_mm / static_cast<double>(rows_);
    cells_.resize(columns_ * rows_);
    for (const GrooveStroke& stroke : grooves.strokes)
        for_each_part(stroke, [&](Point from, Point to) { add(from, to, stroke.half_floor_mm); });
}

/// Cut into pieces that are short against the cylinder and the cells.
void StrokeIndex::add(Point from, Point to, double half_floor_mm) {
    const double most_mm = std::min(kLongestShareOfRound * round_mm_, std::max(cell_x_mm_, cell_y_mm_));
    const double length_mm = std::hypot(to.x - from.x, to.y - from.y);
    const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(length_mm / most_mm)));
    const auto at = [&](std::size_t k) {
        const double share = static_cast<double>(k) / static_cast<double>(count);
        return k == count ? to : Point{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
    };
    for (std::size_t k = 0; k < count; ++k) {
        pieces_.push_back({at(k), at(k + 1), half_floor_mm});
        enter(pieces_.back(), static_cast<std::uint32_t>(pieces_.size() - 1));
    }
}

std::size_t StrokeIndex::row_of(double height_mm) const {
    const double row = std::floor(height_mm / cell_y_mm_);
    return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows_ - 1)));
}

void StrokeIndex::enter(const Piece& piece, std::uint32_t index) {
    const double around_mm = reach_mm_ + piece.half_floor_mm;
    const std::size_t first_row = row_of(std::min(piece.from.y, piece.to.y) - around_mm);
    const std::size_t last_row = row_of(std::max(piece.from.y, piece.to.y) + around_mm);
    const double left = std::floor((std::min(piece.from.x, piece.to.x) - around_mm) / cell_x_mm_);
    const double right = std::floor((std::max(piece.from.x, piece.to.x) + around_mm) / cell_x_mm_);
    const auto columns = static_cast<double>(columns_);
    const std::size_t count = static_cast<std::size_t>(std::min(right - left + 1.0, columns));
    const auto first = static_cast<std::size_t>(left - columns * std::floor(left / columns));
    for (std::size_t row = first_row; row <= last_row; ++row) {
        for (std::size_t k = 0; k < count; ++k)
            cells_[row * columns_ + (first + k) % columns_].push_back(index);
    }
}

double StrokeIndex::beside_floor_mm(double along_mm, double height_mm, const HalfCell& around) const {
    const double diagonal_mm = std::hypot(around.along_mm, around.height_mm);
    const double once_mm = along_mm - round_mm_ * std::floor(along_mm / round_mm_);
    const auto column = std::min(static_cast<std::size_t>(once_mm / cell_x_mm_), columns_ - 1);
    double nearest_mm = std::numeric_limits<double>::infinity();
    for (const std::uint32_t index : cells_[row_of(height_mm) * columns_ + column]) {
        const Piece& piece = pieces_[index];
        const double middle_mm = 0.5 * (piece.from.x + piece.to.x);
        const double turns = std::round((middle_mm - once_mm) / round_mm_);
        const Point at{once_mm + turns * round_mm_, height_mm};
        const double least_mm = nearest_mm + piece.half_floor_mm;
        const double worth_mm = least_mm + diagonal_mm;
        double away2 = distance2(at, piece.from, piece.to);
        if (worth_mm > 0.0 && away2 >= worth_mm * worth_mm) continue;
        if (diagonal_mm > 0.0) away2 = distance2(at, around, piece.from, piece.to);
        nearest_mm = std::min(nearest_mm, std::sqrt(away2) - piece.half_floor_mm);
    }
    return nearest_mm <= reach_mm_ ? nearest_mm : std::numeric_limits<double>::infinity();
}

}  // namespace psicarve::flat
