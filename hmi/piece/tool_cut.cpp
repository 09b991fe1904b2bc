// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/tool_cut.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::piece {

// The nearest point of the tool's front is at the tip or further out, so no ray beyond asin(R / tip) meets
// it.
ReachedColumns::ReachedColumns(const tool::Tool& tool, std::size_t column_count, double direction_rad,
                               double tip_mm) noexcept {
    const double half_rad =
        tool.radius < tip_mm * std::sin(kWidest_rad) ? std::asin(tool.radius / tip_mm) : kWidest_rad;
    const auto columns = static_cast<double>(column_count);
    const double at = direction_rad / (2.0 * kPi) * columns;
    const double reach = half_rad / (2.0 * kPi) * columns;
    const double from = std::ceil(at - reach);
    first = static_cast<std::int64_t>(from);
    count = static_cast<std::size_t>(std::max(0.0, std::floor(at + reach) - from + 1.0));
}

ReachedRows::ReachedRows(const tool::Tool& tool, const StockMap& stock, double height_mm) noexcept {
    const double lowest = std::ceil((height_mm - tool.radius - stock.bottom_mm()) / stock.row_mm() - 0.5);
    const double highest = std::floor((height_mm + tool.radius - stock.bottom_mm()) / stock.row_mm() - 0.5);
    if (highest < 0.0 || lowest > highest) return;
    begin = static_cast<std::size_t>(std::max(0.0, lowest));
    end = std::min(stock.row_count(), static_cast<std::size_t>(highest) + 1);
}

ToolCut::ToolCut(const tool::Tool& tool, StockMap& stock, double point_reach_rad, double point_reach_mm)
    : tool_(tool),
      flank_slope_(static_cast<float>(tool::flank_slope(tool_))),
      point_reach_rad_(point_reach_rad),
      point_reach_mm_(point_reach_mm),
      stock_(stock) {
    for (std::size_t column = 0; column < stock.column_count(); ++column) {
        cosine_.push_back(static_cast<float>(std::cos(stock.direction_rad(column))));
        sine_.push_back(static_cast<float>(std::sin(stock.direction_rad(column))));
    }
}

void ToolCut::aim(double direction_rad, double tip_mm) {
    const ReachedColumns columns(tool_, stock_.column_count(), direction_rad, tip_mm);
    const auto around = static_cast<std::int64_t>(stock_.column_count());
    first_ = static_cast<std::size_t>((columns.first % around + around) % around);
    rays_.resize(columns.count);
    const auto cosine = static_cast<float>(std::cos(direction_rad));
    const auto sine = static_cast<float>(std::sin(direction_rad));
    std::size_t column = first_;
    for (Ray& ray : rays_) {
        const float across = sine_[column] * cosine - cosine_[column] * sine;
        ray = {cosine_[column] * cosine + sine_[column] * sine, across * across};
        if (++column == stock_.column_count()) column = 0;
    }
}

void ToolCut::prick(double direction_rad, double height_mm, double tip_mm) {
    const PrickedRows rows(height_mm - stock_.bottom_mm(), stock_.row_mm(), point_reach_mm_);
    const double columns = static_cast<double>(stock_.column_count());
    const double at = direction_rad / (2.0 * kPi) * columns;
    const double column = std::round(at);
    if (std::abs(at - column) * 2.0 * kPi > point_reach_rad_ * columns) return;
    const double wrapped = column - std::floor(column / columns) * columns;
    for (std::int64_t row = rows.first; row <= rows.last; ++row) {
        if (row < 0 || row >= static_cast<std::int64_t>(stock_.row_count())) continue;
        float& radius = stock_.row(static_cast<std::size_t>(row))[static_cast<std::size_t>(wrapped)];
        radius = std::min(radius, static_cast<float>(tip_mm));
        ++contacts_;
    }
}

void ToolCut::at(double direction_rad, double height_mm, double tip_mm) {
    if (tool_.shape == tool::Shape::point) return prick(direction_rad, height_mm, tip_mm);
    visit_rows(direction_rad, height_mm, tip_mm);
}

double ToolCut::bite_mm(double direction_rad, double height_mm, double tip_mm) {
    only_measures_ = true;
    deepest_ = 0.0F;
    visit_rows(direction_rad, height_mm, tip_mm);
    only_measures_ = false;
    return static_cast<double>(deepest_);
}

void ToolCut::visit_rows(double direction_rad, double height_mm, double tip_mm) {
    const ReachedRows rows(tool_, stock_, height_mm);
    if (rows.begin >= rows.end) return;
    aim(direction_rad, tip_mm);
    for (std::size_t row = rows.begin; row < rows.end; ++row) {
        const double up = stock_.height_mm(row) - height_mm;
        const auto height2 = static_cast<float>(up * up);
        const float across2 = static_cast<float>(tool_.radius * tool_.radius) - height2;
        if (across2 < 0.0F) continue;
        visit_row(stock_.row(row), static_cast<float>(tip_mm), across2, height2);
        contacts_ += rays_.size();
    }
}

template <typename Entry>
float ToolCut::deepest_of_run(const float* radii, const Ray* rays, std::size_t count, float across2,
                              const Entry& entry) const {
    float deepest = 0.0F;
    for (std::size_t i = 0; i < count; ++i) {
        const float radius = radii[i];
        const float bite = radius * radius * rays[i].sine2 <= across2 ? radius - entry(rays[i]) : 0.0F;
        deepest = bite > deepest ? bite : deepest;
    }
    return deepest;
}

template <typename Entry>
void ToolCut::cut_run(float* radii, const Ray* rays, std::size_t count, float across2,
                      const Entry& entry) const {
    for (std::size_t i = 0; i < count; ++i) {
        const float radius = radii[i];
        const float inner = entry(rays[i]);
        const bool is_inside = radius * radius * rays[i].sine2 <= across2;
        radii[i] = is_inside && inner < radius ? inner : radius;
    }
}

void ToolCut::visit_row(std::span<float> radii, float tip, float across2, float height2) {
    constexpr float kNowhere = 1e30F;
    const auto runs = [&](const auto& entry) {
        const std::size_t before_wrap = std::min(rays_.size(), radii.size() - first_);
        if (only_measures_) {
            deepest_ = std::max(
                {deepest_, deepest_of_run(radii.data() + first_, rays_.data(), before_wrap, across2, entry),
                 deepest_of_run(radii.data(), rays_.data() + before_wrap, rays_.size() - before_wrap, across2,
                                entry)});
            return;
        }
        cut_run(radii.data() + first_, rays_.data(), before_wrap, across2, entry);
        cut_run(radii.data(), rays_.data() + before_wrap, rays_.size() - before_wrap, across2, entry);
    };
    if (tool_.shape == tool::Shape::ball) {
        const float centre = tip + static_cast<float>(tool_.radius);
        const float centre2 = centre * centre;
        runs([=](const Ray& ray) {
            const float rest = across2 - centre2 * ray.sine2;
            const float inner = centre * ray.cosine - std::sqrt(std::max(rest, 0.0F));
            return rest >= 0.0F ? inner : kNowhere;
        });
    } else if (tool_.shape == tool::Shape::vee) {
        const float slope = flank_slope_;
        runs([=](const Ray& ray) {
            const float a = ray.cosine * ray.cosine - slope * slope * ray.sine2;
            const float root = std::sqrt(std::max(0.0F, tip * tip * ray.sine2 + a * height2));
            const float inner = (tip * ray.cosine + slope * root) / a;
            return a > 0.0F && inner * inner * ray.sine2 <= across2 ? inner : kNowhere;
        });
    } else {
        runs([=](const Ray& ray) {
            const float inner = tip / ray.cosine;
            return inner * inner * ray.sine2 <= across2 ? inner : kNowhere;
        });
    }
}

}  // namespace psicarve::piece
