// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/job_run.hpp"

#include <algorithm>
#include <limits>

namespace psicarve::cycle {

void JobRun::load(std::uint64_t generation, std::uint64_t points_total, std::uint64_t points_per_layer,
                  bool runs_back) noexcept {
    generation_ = generation;
    points_total_ = points_total;
    points_per_layer_ = points_per_layer;
    runs_back_ = runs_back;
    override_percent_ = kFullFeed_percent;
    rapid_override_percent_ = kFullFeed_percent;
}

Refusal JobRun::judge(LayerRange layers) const noexcept {
    if (points_total_ == 0 || points_per_layer_ == 0) return Refusal::no_job;
    const std::uint64_t layer_count = points_total_ / points_per_layer_;
    const bool is_within = layers.first < layer_count && layers.count <= layer_count - layers.first;
    if (!is_within) return Refusal::no_such_layer;
    // With a layer's last point nothing of it is left to carve.
    const bool has_way = layers.point_number <= points_per_layer_ &&
                         (layers.point_number == 0 || first_step_of(layers) + 1 < points_per_layer_);
    return has_way ? Refusal::none : Refusal::no_such_point;
}

std::uint64_t JobRun::first_step_of(const LayerRange& layers) const noexcept {
    if (layers.point_number == 0) return 0;
    const bool is_back = runs_back_ && layers.first % 2 == 1;
    return is_back ? points_per_layer_ - layers.point_number : layers.point_number - 1;
}

void JobRun::begin(LayerRange layers, std::uint64_t tick) noexcept {
    is_dry_ = layers.is_dry;
    first_layer_ = layers.first;
    first_step_ = first_step_of(layers);
    index_layer_ = layers.first;
    end_layer_ = layers.count == 0 ? points_total_ / points_per_layer_ : first_layer_ + layers.count;
    start_tick_ = tick;
    carve_first_tick_ = 0;
    carve_last_tick_ = 0;
    end_tick_ = 0;
}

// Steps that were lost before the first layer are missing in it, too.
JobRun::Affected JobRun::affected(std::uint32_t layer) const noexcept {
    if (!has_begun_carving() || is_dry_) return {};
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint16_t>::max();
    return {index_layer_, static_cast<std::uint16_t>(std::min(layer - index_layer_ + 1, kMost))};
}

void JobRun::show_in(Sample& sample) const noexcept {
    sample.is_dry = is_dry_ ? 1 : 0;
    sample.points_total = points_total_;
    sample.first_layer = first_layer_;
    sample.first_step = first_step_;
    sample.job_generation = generation_;
    sample.job_start_tick = start_tick_;
    sample.carve_first_tick = carve_first_tick_;
    sample.carve_last_tick = carve_last_tick_;
    sample.job_end_tick = end_tick_;
    sample.override_percent = override_percent_;
    sample.rapid_override_percent = rapid_override_percent_;
}

void JobRun::show_in(PlanRequest& request) const noexcept {
    request.job_generation = generation_;
    request.first_layer = first_layer_;
    request.first_step = first_step_;
    request.end_layer = end_layer_;
    request.is_dry = is_dry_ ? 1 : 0;
}

}  // namespace psicarve::cycle
