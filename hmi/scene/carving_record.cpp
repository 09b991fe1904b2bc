// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/carving_record.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

using verify::kHeadCount;

std::array<std::int64_t, kHeadCount> radii_of(const IncrementEntry& entry) noexcept {
    return {entry.r1_pulses, entry.r2_pulses};
}

/// Marks the rows that these layers are, or are nearer to than the pass' others.
void mark_rows(const verify::JobGeometry& geometry, std::uint32_t first, std::uint32_t end,
               std::vector<std::uint8_t>& marks) {
    const JobView& job = geometry.job();
    const std::uint32_t first_row = geometry.first_row_layer();
    if (first >= first_row) {
        std::fill(marks.begin() + (first - first_row), marks.begin() + (end - first_row), std::uint8_t{1});
        return;
    }
    const auto heights = job.layer_heights_pulses();
    const JobPass& pass = job.passes()[job.pass_of(first)];
    // Beyond the pass' ends there is no other.
    const auto border = [&](std::uint32_t layer, std::uint32_t next) {
        return (heights[layer] + heights[next]) / 2;
    };
    const bool is_lowest = first == pass.first_layer;
    const bool is_highest = end == pass.first_layer + pass.layer_count;
    for (std::uint32_t row = 0; row < geometry.row_count(); ++row) {
        const bool is_above = is_lowest || geometry.height(row) >= border(first, first - 1);
        const bool is_below = is_highest || geometry.height(row) <= border(end - 1, end);
        if (is_above && is_below) marks[row] = 1;
    }
}

}  // namespace

CarvingRecord::CarvingRecord(std::shared_ptr<const cam::PreparedJob> job, const verify::JobGeometry& geometry)
    : job_(std::move(job)),
      geometry_(geometry),
      surface_(geometry),
      has_changed_(surface_.layer_count(), std::uint8_t{0}) {
    const BlankProfile& blank = job_->profile.blank;
    if (!(blank.radius_mm > 0.0)) return;
    for (std::uint32_t cell = 0; cell < geometry_.direction_count(); ++cell) {
        const double direction_rad = rad_from_pulses(geometry_.direction_of(cell), geometry_.rev_pulses());
        blank_mm_.push_back(static_cast<float>(blank.surface_mm(direction_rad)));
    }
}

double CarvingRecord::blank_reach_mm() const noexcept {
    return geometry_.blank_radius_mm();
}

float CarvingRecord::shown_mm(std::uint32_t layer, std::uint32_t cell) const noexcept {
    const float radius_mm = surface_.radii_mm(layer)[cell];
    return blank_mm_.empty() ? radius_mm : std::min(radius_mm, blank_mm_[cell]);
}

Result<std::unique_ptr<CarvingRecord>> CarvingRecord::make(std::shared_ptr<const cam::PreparedJob> job) {
    const auto geometry = verify::JobGeometry::make(job->view, job->profile);
    if (!geometry) return geometry.error();
    return std::unique_ptr<CarvingRecord>{new CarvingRecord{std::move(job), *geometry}};
}

void CarvingRecord::note_change(std::uint32_t layer) {
    ++edition_;
    if (std::exchange(has_changed_[layer], std::uint8_t{1}) == 0) changed_.push_back(layer);
}

std::vector<std::uint32_t> CarvingRecord::take_changed_layers() {
    for (const std::uint32_t layer : changed_) has_changed_[layer] = 0;
    return std::exchange(changed_, {});
}

void CarvingRecord::take(const IncrementEntry& entry) {
    const auto radii = radii_of(entry);
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const verify::HeadGeometry& head = geometry_.head(h);
        const double real_mm = head.real_mm(radii[h]);
        if (real_mm >= geometry_.blank_radius_mm()) continue;
        const std::int64_t direction = geometry_.direction(h, entry.psi_pulses);
        const auto layer = geometry_.row_at(entry.y_pulses + head.height_offset_pulses, direction);
        if (!layer) continue;
        surface_.touch(*layer, geometry_.cell_of(direction), static_cast<float>(real_mm));
        note_deviation(h, *layer, entry, real_mm);
        note_change(*layer);
    }
}

/// Only where the job has a radius: on a layer, not on the way from one to the next. The way may leave the
/// straight line between two points by the path's tolerance, and either axis stands up to a pulse before or
/// behind it: on a steep flank that is many pulses of radius.
void CarvingRecord::note_deviation(std::size_t h, std::uint32_t layer, const IncrementEntry& entry,
                                   double real_mm) {
    const verify::HeadGeometry& head = geometry_.head(h);
    const std::int64_t height = entry.y_pulses + head.height_offset_pulses;
    if (!surface_.is_spiral() && height != geometry_.height(layer)) return;
    const double tolerance_mm = job_->profile.job.path_tolerance_mm;
    const double arc_rad = tolerance_mm / std::max(real_mm, tolerance_mm);
    const auto aside = static_cast<std::int64_t>(
                           std::ceil(arc_rad * static_cast<double>(geometry_.rev_pulses()) / (2.0 * kPi))) +
                       2;
    const std::int64_t direction = geometry_.direction(h, entry.psi_pulses);
    double least_mm = real_mm;
    double most_mm = real_mm;
    bool is_first = true;
    for (const std::int64_t place : {direction - aside, direction, direction + aside}) {
        const auto wanted_mm = geometry_.wanted_mm(layer, place);
        if (!wanted_mm) return;
        least_mm = is_first ? *wanted_mm : std::min(least_mm, *wanted_mm);
        most_mm = is_first ? *wanted_mm : std::max(most_mm, *wanted_mm);
        is_first = false;
    }
    const double off_mm = real_mm - std::clamp(real_mm, least_mm - tolerance_mm, most_mm + tolerance_mm);
    surface_.note_deviation(layer, geometry_.cell_of(direction), std::llround(off_mm * head.pulses_per_mm));
}

void CarvingRecord::take_as_planned(std::uint32_t layers_done, std::uint64_t most_cells) {
    const std::uint64_t most_layers = std::max<std::uint64_t>(most_cells / surface_.direction_count(), 1);
    const std::uint32_t rows_done = layers_done - std::min(layers_done, geometry_.first_row_layer());
    const std::uint64_t last = std::min<std::uint64_t>(rows_done, surface_.layer_count());
    const std::uint64_t end = std::min(last, layers_done_ + most_layers);
    for (; layers_done_ < end; ++layers_done_) {
        bool was_seen = true;
        for (std::uint32_t cell = 0; cell < surface_.direction_count(); ++cell) {
            const bool is_carved = surface_.radii_mm(layers_done_)[cell] < uncarved_mm();
            if (is_carved) continue;
            const auto wanted_mm = geometry_.wanted_mm(layers_done_, geometry_.direction_of(cell));
            if (!wanted_mm || *wanted_mm >= geometry_.blank_radius_mm()) continue;
            surface_.touch(layers_done_, cell, static_cast<float>(*wanted_mm));
            surface_.note_deviation(layers_done_, cell, 0);
            was_seen = false;
        }
        if (!was_seen) ++planned_layers_;
        note_change(layers_done_);
    }
}

void CarvingRecord::set_doubt(std::span<const verify::LayerRange> job_layers) {
    std::vector<std::uint8_t> now(job_layers.empty() ? 0U : surface_.layer_count(), std::uint8_t{0});
    const JobView& job = geometry_.job();
    for (const verify::LayerRange& range : job_layers) {
        const std::uint32_t first = std::min(range.first, job.layer_count());
        const std::uint32_t end = first + std::min(range.count, job.layer_count() - first);
        for (std::uint32_t layer = first; layer < end; layer = std::min(end, job.pass_end(layer)))
            mark_rows(geometry_, layer, std::min(end, job.pass_end(layer)), now);
    }
    const std::vector<std::uint8_t> before = std::exchange(is_in_doubt_, std::move(now));
    for (std::uint32_t layer = 0; layer < surface_.layer_count(); ++layer) {
        const bool was_in_doubt = !before.empty() && before[layer] != 0;
        if (was_in_doubt != is_in_doubt(layer)) note_change(layer);
    }
    ++doubt_edition_;
}

bool CarvingRecord::is_in_doubt(std::uint32_t first, std::uint32_t last) const noexcept {
    if (is_in_doubt_.empty()) return false;
    const auto begin = is_in_doubt_.begin();
    return std::find(begin + first, begin + last + 1, std::uint8_t{1}) != begin + last + 1;
}

void CarvingRecord::put(std::uint32_t layer, std::uint32_t cell, float radius_mm) {
    surface_.put(layer, cell, radius_mm);
    note_change(layer);
}

MachinePose CarvingRecord::pose(const verify::Positions& positions_pulses, double middle_mm) const noexcept {
    const auto direction_rad = [&](std::size_t head) {
        return rad_from_pulses(geometry_.direction(head, positions_pulses[index_of(Axis::psi)]),
                               geometry_.rev_pulses());
    };
    MachinePose pose;
    pose.part_turn_rad = kPi - direction_rad(0);
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const verify::HeadGeometry& head = geometry_.head(h);
        pose.heads[h].direction_rad = pose.part_turn_rad + direction_rad(h);
        pose.heads[h].radius_mm = head.real_mm(positions_pulses[index_of(verify::kHeads[h])]);
        pose.heads[h].height_mm =
            mm_from_pulses(positions_pulses[index_of(Axis::y)] + head.height_offset_pulses,
                           geometry_.y_pulses_per_mm()) -
            middle_mm;
    }
    return pose;
}

}  // namespace psicarve::session
