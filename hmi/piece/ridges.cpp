// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/ridges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "hmi/slice/placement.hpp"
#include "shared/base/units.hpp"

namespace psicarve::piece {
namespace {

constexpr std::size_t kMostRidges = 2048;
// The histogram's finest step: a smaller projection is no ridge.
constexpr double kRidge_mm = 0.01;
constexpr double kBeside_mm = 0.02;
constexpr double kSame_mm = 1e-3;
constexpr std::size_t kWideCells = 5;

/// A map's radii without features less than kWideCells wide in their row: the least of that many neighbours,
/// then the largest of those.
std::vector<float> without_thin_parts(std::span<const float> radii_mm, std::size_t column_count) {
    std::vector<float> wide(radii_mm.begin(), radii_mm.end());
    std::vector<float> least(column_count);
    const auto over = [column_count](std::size_t first, const auto& radii, const auto& better) {
        float best = radii[first % column_count];
        for (std::size_t k = 1; k < kWideCells; ++k) best = better(best, radii[(first + k) % column_count]);
        return best;
    };
    for (std::size_t begin = 0; begin < wide.size(); begin += column_count) {
        const std::span<float> row(wide.data() + begin, column_count);
        for (std::size_t c = 0; c < column_count; ++c)
            least[c] = over(c, row, [](float a, float b) { return std::min(a, b); });
        for (std::size_t c = 0; c < column_count; ++c) {
            row[c] = over(c + column_count - (kWideCells - 1), least,
                          [](float a, float b) { return std::max(a, b); });
        }
    }
    return wide;
}

/// Of all layers, rising.
std::vector<double> heights_mm(const verify::JobGeometry& geometry) {
    std::vector<double> heights;
    for (std::uint32_t row = 0; row < geometry.row_count(); ++row)
        heights.push_back(static_cast<double>(geometry.height(row)) / geometry.y_pulses_per_mm());
    std::sort(heights.begin(), heights.end());
    return heights;
}

/// Follows a model's edges and keeps places that stand out of a map's cells.
class RidgeSearch {
public:
    RidgeSearch(const PlacedModel& model, const StockMap& blank, std::span<const float> wanted_mm,
                std::span<const std::size_t> rows, const std::vector<double>& layers_mm, bool is_point)
        : model_(model),
          blank_(blank),
          wide_mm_(without_thin_parts(wanted_mm, blank.column_count())),
          is_point_(is_point),
          layers_mm_(layers_mm),
          is_carved_(blank.row_count(), 0),
          lowest_(slice::placed(model.placement.up, model.mesh->facts.min)[2]) {
        for (const std::size_t row : rows) is_carved_[row] = 1;
        if (rows.empty()) return;
        first_row_ = static_cast<double>(rows.front());
        last_row_ = static_cast<double>(rows.back());
    }

    std::vector<Ridge> found() {
        for (const model::Triangle& facet : model_.mesh->triangles) {
            std::array<Point, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) corners[k] = on_table(facet.vertices[k]);
            for (std::size_t k = 0; k < 3; ++k) follow(corners[k], corners[(k + 1) % 3]);
        }
        std::vector<Ridge> all;
        for (const auto& [cell, ridge] : by_cell_) all.push_back(ridge);
        const auto stands_out_more = [](const Ridge& a, const Ridge& b) {
            if (a.above_mm != b.above_mm) return a.above_mm > b.above_mm;
            return a.row != b.row ? a.row < b.row : a.column < b.column;
        };
        std::sort(all.begin(), all.end(), stands_out_more);
        if (all.size() > kMostRidges) all.resize(kMostRidges);
        std::sort(all.begin(), all.end(), [](const Ridge& a, const Ridge& b) {
            return a.row != b.row ? a.row < b.row : a.column < b.column;
        });
        return all;
    }

private:
    using Point = std::array<double, 3>;

    Point on_table(const std::array<float, 3>& vertex) const {
        const Point file = {vertex[0] + model_.mesh->origin[0], vertex[1] + model_.mesh->origin[1],
                            vertex[2] + model_.mesh->origin[2]};
        const Point at = slice::placed(model_.placement.up, file);
        return {(at[0] - model_.placement.axis_x) * model_.scale,
                (at[1] - model_.placement.axis_y) * model_.scale,
                model_.base_mm + (at[2] - lowest_) * model_.scale};
    }
    double row_of(double height_mm) const { return (height_mm - blank_.bottom_mm()) / blank_.row_mm() - 0.5; }

    /// Without its end, where another edge of the facet begins.
    void follow(const Point& from, const Point& to) {
        const auto part = [&](double t) {
            return Point{from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]),
                         from[2] + t * (to[2] - from[2])};
        };
        const double low = std::max(first_row_ - 0.5, std::min(row_of(from[2]), row_of(to[2])));
        const double high = std::min(last_row_ + 0.5, std::max(row_of(from[2]), row_of(to[2])));
        if (low > high) return;
        // At layers: a tool's flanks leave more between them.
        const auto at_height = [&](double height_mm) { return (height_mm - from[2]) / (to[2] - from[2]); };
        const double least_mm = std::min(from[2], to[2]);
        const double most_mm = std::max(from[2], to[2]);
        for (auto height = std::lower_bound(layers_mm_.begin(), layers_mm_.end(), least_mm);
             height != layers_mm_.end() && *height <= most_mm; ++height)
            look_at(part(most_mm > least_mm ? at_height(*height) : 0.0));
        // The material that a point leaves above and below its layers does not matter.
        if (is_point_) return;
        const double length_mm = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
        const double steps = std::max(1.0, std::ceil(length_mm / cell_mm_));
        const double rise = row_of(to[2]) - row_of(from[2]);
        const auto step_at = [&](double row) {
            return rise != 0.0 ? steps * (row - row_of(from[2])) / rise : 0.0;
        };
        const double first = rise == 0.0 ? 0.0 : std::max(0.0, std::min(step_at(low), step_at(high)));
        const double last = rise == 0.0 ? steps : std::max(step_at(low), step_at(high));
        for (double i = std::ceil(first); i <= last && i < steps; i += 1.0) look_at(part(i / steps));
    }

    void look_at(const Point& at) {
        const double row = std::round(row_of(at[2]));
        if (row < 0.0 || row >= static_cast<double>(blank_.row_count())) return;
        Ridge ridge;
        ridge.row = static_cast<std::size_t>(row);
        if (is_carved_[ridge.row] == 0) return;
        const double angle = std::atan2(at[1], at[0]);
        ridge.direction_rad = angle < 0.0 ? angle + 2.0 * kPi : angle;
        ridge.height_mm = at[2];
        const auto columns = static_cast<double>(blank_.column_count());
        const double column = ridge.direction_rad / (2.0 * kPi) * columns;
        ridge.column = static_cast<std::size_t>(std::lround(column)) % blank_.column_count();
        ridge.radius_mm = std::min(std::hypot(at[0], at[1]), blank_.surface_mm(ridge.column));
        ridge.above_mm = ridge.radius_mm - highest_around(row_of(at[2]), column);
        if (ridge.above_mm <= kRidge_mm) return;
        const auto [entry, is_new] =
            by_cell_.try_emplace(ridge.row * blank_.column_count() + ridge.column, ridge);
        if (!is_new && entry->second.above_mm + kSame_mm < ridge.above_mm) entry->second = ridge;
    }

    /// The highest of the cells on all sides.
    double highest_around(double row, double column) const {
        const double most_row = static_cast<double>(blank_.row_count()) - 1.0;
        const auto low = static_cast<std::size_t>(std::clamp(std::floor(row), 0.0, most_row));
        const auto high = static_cast<std::size_t>(std::clamp(std::ceil(row), 0.0, most_row));
        const auto left = static_cast<std::size_t>(std::floor(column)) % blank_.column_count();
        const std::size_t right = (left + 1) % blank_.column_count();
        const auto wide = [&](std::size_t r, std::size_t c) {
            return wide_mm_[r * blank_.column_count() + c];
        };
        return std::max({wide(low, left), wide(low, right), wide(high, left), wide(high, right)});
    }

    const PlacedModel& model_;
    const StockMap& blank_;
    std::vector<float> wide_mm_;
    bool is_point_;
    const std::vector<double>& layers_mm_;
    std::vector<char> is_carved_;
    double lowest_;
    double first_row_ = 1.0;
    double last_row_ = 0.0;
    double cell_mm_ = std::min(blank_.row_mm(), blank_.blank_radius_mm() * blank_.direction_rad(1));
    std::unordered_map<std::size_t, Ridge> by_cell_;
};

}  // namespace

Ridges::Ridges(const PlacedModel& model, const tool::Tool& tool, const StockMap& blank,
               std::span<const float> wanted_mm, std::span<const std::size_t> rows,
               const verify::JobGeometry& geometry)
    : tool_(tool),
      bottom_mm_(blank.bottom_mm()),
      row_mm_(blank.row_mm()),
      rad_per_pulse_(geometry.rad_per_pulse()),
      point_reach_mm_(kPointReach_pulses / geometry.y_pulses_per_mm()),
      layers_mm_(heights_mm(geometry)),
      ridges_(RidgeSearch(model, blank, wanted_mm, rows, layers_mm_, is_point()).found()) {
    for (const Ridge& ridge : ridges_) {
        Rays rays{std::cos(ridge.direction_rad),
                  std::sin(ridge.direction_rad),
                  std::max(kBeside_mm, ridge.radius_mm * rad_per_pulse_),
                  {}};
        rays.radius_mm.fill(static_cast<float>(ridge.radius_mm));
        rays_.push_back(rays);
    }
    std::size_t at = 0;
    for (std::size_t row = 0; row <= blank.row_count(); ++row) {
        while (at < ridges_.size() && ridges_[at].row < row) ++at;
        row_begin_.push_back(at);
    }
}

void Ridges::cut(double direction_rad, double height_mm, double tip_mm) {
    if (ridges_.empty()) return;
    if (is_point()) return prick(direction_rad, height_mm, tip_mm);
    const double reach_mm = tool_.radius + row_mm_;
    const double most = static_cast<double>(row_begin_.size()) - 1.0;
    const double low = std::floor((height_mm - reach_mm - bottom_mm_) / row_mm_);
    const double high = std::ceil((height_mm + reach_mm - bottom_mm_) / row_mm_);
    const double cosine = std::cos(direction_rad);
    const double sine = std::sin(direction_rad);
    const auto begin = row_begin_[static_cast<std::size_t>(std::clamp(low, 0.0, most))];
    const auto end = row_begin_[static_cast<std::size_t>(std::clamp(high, 0.0, most))];
    for (std::size_t i = begin; i < end; ++i) {
        const double ahead = rays_[i].cosine * cosine + rays_[i].sine * sine;
        const double across = rays_[i].sine * cosine - rays_[i].cosine * sine;
        if (ahead <= 0.0 || std::abs(across) * ridges_[i].radius_mm > tool_.radius + rays_[i].beside_mm)
            continue;
        if (tip_mm > ridges_[i].radius_mm) continue;
        cut_rays(i, ahead, across, ridges_[i].height_mm - height_mm, tip_mm);
    }
}

void Ridges::cut_rays(std::size_t index, double cosine, double sine, double up_mm, double tip_mm) {
    Rays& rays = rays_[index];
    const double beside_rad = rays.beside_mm / ridges_[index].radius_mm;
    const auto cut = [&](std::size_t ray, double ray_sine, double ray_up_mm) {
        const double radius_mm = rays.radius_mm[ray];
        const double across_mm = radius_mm * ray_sine;
        if (across_mm * across_mm + ray_up_mm * ray_up_mm > tool_.radius * tool_.radius) return;
        rays.radius_mm[ray] = static_cast<float>(std::min(radius_mm, entry_mm(ray_sine, ray_up_mm, tip_mm)));
    };
    cut(0, sine, up_mm);
    cut(1, sine + cosine * beside_rad, up_mm);
    cut(2, sine - cosine * beside_rad, up_mm);
    cut(3, sine, up_mm + rays.beside_mm);
    cut(4, sine, up_mm - rays.beside_mm);
}

/// As ToolCut's.
double Ridges::entry_mm(double sine, double up_mm, double tip_mm) const noexcept {
    constexpr double kNowhere_mm = std::numeric_limits<double>::max();
    const double sine2 = sine * sine;
    if (sine2 >= 1.0) return kNowhere_mm;
    const double cosine = std::sqrt(1.0 - sine2);
    const double across2 = tool_.radius * tool_.radius - up_mm * up_mm;
    double inner_mm = tip_mm / cosine;
    if (tool_.shape == tool::Shape::ball) {
        const double centre_mm = tip_mm + tool_.radius;
        const double rest = across2 - centre_mm * centre_mm * sine2;
        return rest >= 0.0 ? centre_mm * cosine - std::sqrt(rest) : kNowhere_mm;
    }
    if (tool_.shape == tool::Shape::vee) {
        const double slope = tool::flank_slope(tool_);
        const double a = cosine * cosine - slope * slope * sine2;
        if (a <= 0.0) return kNowhere_mm;
        inner_mm = (tip_mm * cosine + slope * std::sqrt(tip_mm * tip_mm * sine2 + a * up_mm * up_mm)) / a;
    }
    return inner_mm * inner_mm * sine2 <= across2 ? inner_mm : kNowhere_mm;
}

void Ridges::prick(double direction_rad, double height_mm, double tip_mm) {
    const PrickedRows rows(height_mm - bottom_mm_, row_mm_, point_reach_mm_);
    const auto row_count = static_cast<std::int64_t>(row_begin_.size()) - 1;
    const auto begin = static_cast<std::size_t>(std::clamp<std::int64_t>(rows.first, 0, row_count));
    const auto end = static_cast<std::size_t>(std::clamp<std::int64_t>(rows.last + 1, 0, row_count));
    for (std::size_t i = row_begin_[begin]; i < row_begin_[end]; ++i) {
        const double off_rad = std::remainder(direction_rad - ridges_[i].direction_rad, 2.0 * kPi);
        const double beside_rad = rays_[i].beside_mm / ridges_[i].radius_mm;
        const auto prick_ray = [&](std::size_t ray, double ray_rad) {
            // Half a pulse, and a margin for rounding.
            if (std::abs(off_rad - ray_rad) > 0.500001 * rad_per_pulse_) return;
            rays_[i].radius_mm[ray] = std::min(rays_[i].radius_mm[ray], static_cast<float>(tip_mm));
        };
        prick_ray(0, 0.0);
        prick_ray(1, beside_rad);
        prick_ray(2, -beside_rad);
    }
}

double Ridges::missing_mm(std::size_t index) const noexcept {
    const Rays& rays = rays_[index];
    const auto short_by = [&](std::size_t ray) {
        return ridges_[index].radius_mm - static_cast<double>(rays.radius_mm[ray]);
    };
    double missing_mm = short_by(0);
    const std::size_t count = is_point() ? 3 : kRays;
    for (std::size_t ray = 1; ray < count; ++ray) {
        // Material as high stands that near.
        if (short_by(ray) <= rays.beside_mm && missing_mm > rays.beside_mm) return 0.0;
        missing_mm = std::min(missing_mm, std::hypot(short_by(ray), rays.beside_mm));
    }
    return missing_mm;
}

bool Ridges::is_cleared(double height_mm) const {
    const auto above = std::lower_bound(layers_mm_.begin(), layers_mm_.end(), height_mm);
    if (is_point() || above == layers_mm_.end() || above == layers_mm_.begin()) return false;
    const double half_mm = 0.5 * (*above - *(above - 1));
    return half_mm < tool_.radius && tool::rise(tool_, half_mm) <= row_mm_;
}

}  // namespace psicarve::piece
