// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/carved_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "hmi/scene/colour_map.hpp"
#include "hmi/scene/space_picture.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr std::uint32_t kNoRow = ~std::uint32_t{0};

}  // namespace

std::vector<VertexRange> ranges_of_rows(const std::vector<std::uint32_t>& rows, std::size_t round) {
    std::vector<VertexRange> ranges;
    for (const std::uint32_t row : rows) {
        const std::size_t first = row * round;
        if (!ranges.empty() && ranges.back().first + ranges.back().count == first)
            ranges.back().count += round;
        else
            ranges.push_back({first, round});
    }
    return ranges;
}

CarvedScene::CarvedScene(const CarvingRecord& record, const CarvedScenePlan& plan)
    : plan_(plan),
      round_(std::clamp<std::size_t>(record.surface().direction_count(), 3,
                                     std::max<std::size_t>(plan.most_round, 3))),
      up_(std::min<std::size_t>(record.surface().layer_count(), plan.most_up)),
      layer_count_(record.surface().layer_count()),
      middle_mm_((record.bottom_mm() + record.top_mm()) / 2.0),
      row_of_layer_(layer_count_, kNoRow),
      scene_(std::make_shared<MeshScene>()) {
    const verify::JobGeometry& geometry = record.geometry();
    for (std::size_t column = 0; column < round_; ++column) {
        const auto cell = static_cast<std::uint32_t>(column * geometry.direction_count() / round_);
        const double angle_rad = rad_from_pulses(geometry.direction_of(cell), geometry.rev_pulses());
        directions_.push_back(
            {static_cast<float>(std::cos(angle_rad)), static_cast<float>(std::sin(angle_rad))});
    }
    const double across_mm = 2.0 * record.blank_reach_mm();
    scene_->size = {across_mm, across_mm, record.top_mm() - record.bottom_mm()};
    scene_->vertices.resize(up_ * round_ + 1);
    scene_->vertex_rgb.resize(up_ * round_ + 1, plan_.blank_rgb);
    for (std::size_t row = 0; row < up_; ++row) {
        row_of_layer_[layer_of(row)] = static_cast<std::uint32_t>(row);
        fill_row(record, row);
    }
    // The lid: without it the view looks into the blank.
    scene_->vertices.back() = {0.0F, 0.0F, static_cast<float>(scene_->size[2] / 2.0)};
    scene_->facets = lathe_facets(round_, up_, 1);
    if (plan_.coarse_step > 1) scene_->coarse_facets = lathe_facets(round_, up_, plan_.coarse_step);
}

std::uint32_t CarvedScene::layer_of(std::size_t row) const noexcept {
    return static_cast<std::uint32_t>(up_ > 1 ? row * (layer_count_ - 1) / (up_ - 1) : 0);
}

std::uint32_t CarvedScene::colour_of(const CarvingRecord& record, std::uint32_t layer,
                                     std::uint32_t cell) const noexcept {
    if (!record.is_carved(layer, cell)) return plan_.blank_rgb;
    if (plan_.colouring == Colouring::radius) {
        const auto radius_mm = static_cast<double>(record.shown_mm(layer, cell));
        return viridis((radius_mm - plan_.least_mm) / (plan_.most_mm - plan_.least_mm));
    }
    if (plan_.colouring == Colouring::deviation) {
        const std::int32_t pulses = record.deviation_pulses(layer, cell);
        if (std::abs(pulses) > plan_.neutral_pulses)
            return vik(0.5 + 0.5 * static_cast<double>(pulses) / static_cast<double>(plan_.reach_pulses));
    }
    return plan_.done_rgb;
}

bool CarvedScene::is_in_doubt(const CarvingRecord& record, std::size_t row) const noexcept {
    const std::uint32_t first = layer_of(row);
    return record.is_in_doubt(first, row + 1 < up_ ? std::max(first, layer_of(row + 1) - 1U) : first);
}

void CarvedScene::fill_row(const CarvingRecord& record, std::size_t row) {
    const std::uint32_t layer = layer_of(row);
    const std::size_t cells = record.surface().direction_count();
    const auto height = static_cast<float>(record.surface().layer_height_mm(layer) - middle_mm_);
    const bool is_doubtful = is_in_doubt(record, row);
    for (std::size_t column = 0; column < round_; ++column) {
        const auto cell = static_cast<std::uint32_t>(column * cells / round_);
        const auto& [cosine, sine] = directions_[column];
        const std::size_t place = row * round_ + column;
        const float radius = record.shown_mm(layer, cell);
        scene_->vertices[place] = {radius * cosine, radius * sine, height};
        scene_->vertex_rgb[place] =
            is_doubtful && record.is_carved(layer, cell) ? plan_.doubt_rgb : colour_of(record, layer, cell);
    }
}

std::vector<VertexRange> CarvedScene::update(CarvingRecord& record) {
    std::vector<std::uint32_t> rows;
    for (const std::uint32_t layer : record.take_changed_layers()) {
        if (row_of_layer_[layer] != kNoRow) rows.push_back(row_of_layer_[layer]);
    }
    if (std::exchange(doubt_edition_, record.doubt_edition()) != record.doubt_edition()) {
        rows.resize(up_);
        std::iota(rows.begin(), rows.end(), 0U);
    }
    std::sort(rows.begin(), rows.end());
    for (const std::uint32_t row : rows) fill_row(record, row);
    return ranges_of_rows(rows, round_);
}

}  // namespace psicarve::session
