// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/stock_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "hmi/scene/colour_map.hpp"
#include "hmi/scene/space_picture.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr double kUncut_mm = 1e-4;  // as rounding may leave a cell of the blank

}  // namespace

StockScene::StockScene(const CarvingRecord& record, piece::PieceFront& front, const CarvedScenePlan& plan)
    : plan_(plan),
      front_(front),
      round_(std::min(front.shown().column_count(), std::max<std::size_t>(plan.most_round, 3))),
      up_(std::min(front.shown().row_count(), std::max<std::size_t>(plan.most_up, 2))),
      middle_mm_(front.shown().bottom_mm() +
                 0.5 * front.shown().row_mm() * static_cast<double>(front.shown().row_count())),
      scene_(std::make_shared<MeshScene>()) {
    front_.take_changed_rows();
    const piece::StockMap& stock = front_.shown();
    for (std::size_t column = 0; column < round_; ++column) {
        const double angle_rad = stock.direction_rad(column * stock.column_count() / round_);
        directions_.push_back(
            {static_cast<float>(std::cos(angle_rad)), static_cast<float>(std::sin(angle_rad))});
    }
    const double across_mm = 2.0 * stock.blank_radius_mm();
    const double height_mm = stock.row_mm() * static_cast<double>(stock.row_count());
    scene_->size = {across_mm, across_mm, height_mm};
    scene_->vertices.resize(up_ * round_ + 1);
    scene_->vertex_rgb.resize(up_ * round_ + 1, plan_.blank_rgb);
    for (std::size_t up = 0; up < up_; ++up) fill_row(record, up);
    // The lid: without it the view looks into the blank.
    scene_->vertices.back() = {0.0F, 0.0F, static_cast<float>(height_mm / 2.0)};
    scene_->facets = lathe_facets(round_, up_, 1);
    if (plan_.coarse_step > 1) scene_->coarse_facets = lathe_facets(round_, up_, plan_.coarse_step);
}

std::size_t StockScene::stock_row(std::size_t up) const noexcept {
    return up_ > 1 ? up * (front_.shown().row_count() - 1) / (up_ - 1) : 0;
}

bool StockScene::is_in_doubt(const CarvingRecord& record, std::size_t up) const noexcept {
    const verify::JobGeometry& geometry = record.geometry();
    const auto row_at = [&](std::size_t at) {
        const double height_mm = front_.shown().height_mm(stock_row(at));
        const std::int64_t height =
            std::clamp<std::int64_t>(std::llround(height_mm * geometry.y_pulses_per_mm()), geometry.height(0),
                                     geometry.height(geometry.row_count() - 1));
        return geometry.row_at(height, 0).value_or(0);
    };
    const std::uint32_t first = row_at(up);
    return record.is_in_doubt(first, std::max(first, up + 1 < up_ ? row_at(up + 1) : first));
}

std::uint32_t StockScene::colour_of(const CarvingRecord& record, std::size_t row, std::size_t column,
                                    bool is_doubtful) const {
    const piece::StockMap& stock = front_.shown();
    const auto radius_mm = static_cast<double>(stock.row(row)[column]);
    if (radius_mm >= stock.surface_mm(column) - kUncut_mm) return plan_.blank_rgb;
    if (is_doubtful) return plan_.doubt_rgb;
    if (plan_.colouring == Colouring::radius)
        return viridis((radius_mm - plan_.least_mm) / (plan_.most_mm - plan_.least_mm));
    if (plan_.colouring == Colouring::deviation) {
        const verify::JobGeometry& geometry = record.geometry();
        const auto direction = static_cast<std::int64_t>(static_cast<double>(column) /
                                                         static_cast<double>(stock.column_count()) *
                                                         static_cast<double>(geometry.rev_pulses()));
        const auto layer =
            geometry.row_at(std::llround(stock.height_mm(row) * geometry.y_pulses_per_mm()), direction);
        const std::uint32_t cell = geometry.cell_of(direction);
        if (!layer || !record.is_carved(*layer, cell)) return plan_.done_rgb;
        const std::int32_t pulses = record.deviation_pulses(*layer, cell);
        if (std::abs(pulses) > plan_.neutral_pulses)
            return vik(0.5 + 0.5 * static_cast<double>(pulses) / static_cast<double>(plan_.reach_pulses));
    }
    return plan_.done_rgb;
}

void StockScene::fill_row(const CarvingRecord& record, std::size_t up) {
    const piece::StockMap& stock = front_.shown();
    const std::size_t row = stock_row(up);
    // The piece ends where its outer rows do, not in their middle.
    double height_mm = stock.height_mm(row) - middle_mm_;
    if (up == 0) height_mm = -scene_->size[2] / 2.0;
    if (up + 1 == up_) height_mm = scene_->size[2] / 2.0;
    const bool is_doubtful = is_in_doubt(record, up);
    for (std::size_t at = 0; at < round_; ++at) {
        const std::size_t column = at * stock.column_count() / round_;
        const float radius = stock.row(row)[column];
        const auto& [cosine, sine] = directions_[at];
        scene_->vertices[up * round_ + at] = {radius * cosine, radius * sine, static_cast<float>(height_mm)};
        scene_->vertex_rgb[up * round_ + at] = colour_of(record, row, column, is_doubtful);
    }
}

/// The rows that are nearer to this layer than to any other, and some more.
void StockScene::note_layer(const CarvingRecord& record, std::uint32_t layer,
                            std::vector<std::uint8_t>& has_changed) {
    const piece::StockMap& stock = front_.shown();
    const std::uint32_t last = record.surface().layer_count() - 1;
    const double low_mm = record.surface().layer_height_mm(layer > 0 ? layer - 1 : 0);
    const double high_mm = record.surface().layer_height_mm(std::min(layer + 1, last));
    const double least_mm = stock.row_mm();
    const auto row_at = [&](double height_mm) {
        const double row = std::floor((height_mm - stock.bottom_mm()) / stock.row_mm());
        return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(stock.row_count() - 1)));
    };
    for (std::size_t row = row_at(low_mm - least_mm); row <= row_at(high_mm + least_mm); ++row)
        has_changed[row] = 1;
}

std::vector<VertexRange> StockScene::update(CarvingRecord& record) {
    std::vector<std::uint8_t> has_changed(front_.shown().row_count(), std::uint8_t{0});
    for (const std::size_t row : front_.take_changed_rows()) has_changed[row] = 1;
    const std::vector<std::uint32_t> layers = record.take_changed_layers();
    if (plan_.colouring == Colouring::deviation) {
        for (const std::uint32_t layer : layers) note_layer(record, layer, has_changed);
    }
    if (std::exchange(doubt_edition_, record.doubt_edition()) != record.doubt_edition())
        std::fill(has_changed.begin(), has_changed.end(), std::uint8_t{1});
    std::vector<std::uint32_t> rows;
    for (std::size_t up = 0; up < up_; ++up) {
        if (has_changed[stock_row(up)] == 0) continue;
        fill_row(record, up);
        rows.push_back(static_cast<std::uint32_t>(up));
    }
    return ranges_of_rows(rows, round_);
}

}  // namespace psicarve::session
