// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/carving_record.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/units.hpp"

namespace psicarve::session {
namespace {

using verify::kHeadCount;

std::array<std::int64_t, kHeadCount> radii_of(const IncrementEntry& entry) noexcept {
    return {entry.r1_pulses, entry.r2_pulses};
}

}  // namespace

CarvingRecord::CarvingRecord(std::shared_ptr<const cam::PreparedJob> job, const verify::JobGeometry& geometry)
    : job_(std::move(job)), geometry_(geometry), surface_(geometry) {}

Result<std::unique_ptr<CarvingRecord>> CarvingRecord::make(std::shared_ptr<const cam::PreparedJob> job) {
    const auto geometry = verify::JobGeometry::make(job->view, job->profile);
    if (!geometry) return geometry.error();
    return std::unique_ptr<CarvingRecord>{new CarvingRecord{std::move(job), *geometry}};
}

void CarvingRecord::take(const IncrementEntry& entry) {
    last_ = entry;
    const auto radii = radii_of(entry);
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const verify::HeadGeometry& head = geometry_.head(h);
        const double real_mm = head.real_mm(radii[h]);
        if (real_mm >= geometry_.blank_radius_mm()) continue;
        const std::int64_t direction = geometry_.direction(h, entry.psi_pulses);
        const auto layer = geometry_.layer_at(entry.y_pulses + head.height_offset_pulses, direction);
        if (!layer) continue;
        surface_.touch(*layer, geometry_.cell_of(direction), static_cast<float>(real_mm));
        ++edition_;
    }
}

void CarvingRecord::take_as_planned(std::uint32_t layers_done) {
    layers_done = std::min(layers_done, surface_.layer_count());
    for (; layers_done_ < layers_done; ++layers_done_) {
        bool was_seen = true;
        for (std::uint32_t cell = 0; cell < surface_.direction_count(); ++cell) {
            const auto wanted_mm = geometry_.wanted_mm(layers_done_, geometry_.direction_of(cell));
            const bool is_carved = surface_.radii_mm(layers_done_)[cell] < uncarved_mm();
            if (!wanted_mm || is_carved || *wanted_mm >= geometry_.blank_radius_mm()) continue;
            surface_.touch(layers_done_, cell, static_cast<float>(*wanted_mm));
            was_seen = false;
        }
        if (!was_seen) ++planned_layers_;
        ++edition_;
    }
}

void CarvingRecord::start_anew() {
    surface_.clear();
    last_.reset();
    planned_layers_ = 0;
    layers_done_ = 0;
    ++edition_;
}

std::optional<std::array<double, 3>> CarvingRecord::tip(std::size_t head) const noexcept {
    if (!last_) return std::nullopt;
    const verify::HeadGeometry& geometry = geometry_.head(head);
    const double real_mm = geometry.real_mm(radii_of(*last_)[head]);
    const double angle_rad =
        rad_from_pulses(geometry_.direction(head, last_->psi_pulses), geometry_.rev_pulses());
    const double y_mm =
        mm_from_pulses(last_->y_pulses + geometry.height_offset_pulses, geometry_.y_pulses_per_mm());
    return std::array{real_mm * std::cos(angle_rad), real_mm * std::sin(angle_rad),
                      y_mm - (bottom_mm() + top_mm()) / 2.0};
}

MeshScene CarvingRecord::scene(std::size_t most_round, std::size_t most_up, std::uint32_t done_rgb,
                               std::uint32_t blank_rgb) const {
    const std::size_t round =
        std::clamp<std::size_t>(surface_.direction_count(), 3, std::max<std::size_t>(most_round, 3));
    const std::size_t up = std::min<std::size_t>(surface_.layer_count(), most_up);
    const double middle_mm = (bottom_mm() + top_mm()) / 2.0;
    MeshScene scene;
    std::vector<bool> is_carved;
    for (std::size_t row = 0; row < up; ++row) {
        const auto layer =
            static_cast<std::uint32_t>(up > 1 ? row * (surface_.layer_count() - 1) / (up - 1) : 0);
        const auto radii = surface_.radii_mm(layer);
        for (std::size_t column = 0; column < round; ++column) {
            const auto cell = static_cast<std::uint32_t>(column * radii.size() / round);
            const double angle_rad = rad_from_pulses(geometry_.direction_of(cell), geometry_.rev_pulses());
            scene.vertices.push_back({static_cast<float>(radii[cell] * std::cos(angle_rad)),
                                      static_cast<float>(radii[cell] * std::sin(angle_rad)),
                                      static_cast<float>(surface_.layer_height_mm(layer) - middle_mm)});
            is_carved.push_back(radii[cell] < uncarved_mm() || layer < layers_done_);
        }
    }
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        scene.facets.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
        scene.facet_rgb.push_back(is_carved[a] ? done_rgb : blank_rgb);
    };
    for (std::size_t row = 0; row + 1 < up; ++row) {
        for (std::size_t column = 0; column < round; ++column) {
            const std::size_t here = row * round + column;
            const std::size_t beside = row * round + (column + 1) % round;
            add(here, beside, here + round);
            add(beside, beside + round, here + round);
        }
    }
    // The lid: without it one looks into the blank.
    scene.vertices.push_back({0.0F, 0.0F, static_cast<float>(top_mm() - middle_mm)});
    is_carved.push_back(false);
    const std::size_t centre = scene.vertices.size() - 1;
    for (std::size_t column = 0; column < round; ++column)
        add((up - 1) * round + column, (up - 1) * round + (column + 1) % round, centre);
    const double across_mm = 2.0 * geometry_.blank_radius_mm();
    scene.size = {across_mm, across_mm, top_mm() - bottom_mm()};
    return scene;
}

}  // namespace psicarve::session
