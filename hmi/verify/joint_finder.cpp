// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/joint_finder.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {

constexpr std::int64_t kRestBeforeDry_ns = 5 * kNsPerMs;  ///< half of what a core rests before it carves

}  // namespace

JointFinder::JointFinder(const JobGeometry& geometry, bool is_of_dry_run)
    : geometry_(geometry), is_of_dry_run_(is_of_dry_run), by_height_(geometry.layer_count()) {
    const JobView& job = geometry_.job();
    std::iota(by_height_.begin(), by_height_.end(), 0U);
    std::stable_sort(by_height_.begin(), by_height_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return job.y_pulses(a, 0) < job.y_pulses(b, 0);
    });
    for (const std::uint32_t layer : by_height_) {
        const std::int64_t rise = job.y_pulses(layer, geometry_.point_count() - 1) - job.y_pulses(layer, 0);
        most_rise_ = std::max(most_rise_, rise);
    }
}

void JointFinder::stand_at(const Positions& positions) noexcept {
    last_ = positions;
    end_dry();
}

bool JointFinder::settle(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    const Positions from = std::exchange(last_, positions);
    if (spindle_on || positions[0] != from[0] || positions[1] != from[1]) end_dry();
    if (positions == from) return false;
    const bool has_rested = time_ns - std::exchange(moved_ns_, time_ns) >= kRestBeforeDry_ns;
    if (spindle_on) return is_met(positions);
    if (!is_of_dry_run_ || positions[0] != from[0] || positions[1] != from[1]) return false;
    is_dry_ = (is_dry_ || (has_rested && !points_at(from).empty())) && !turns_back(from, positions);
    return is_dry_ && passes_dry(positions);
}

bool JointFinder::is_met(const Positions& at) {
    return std::ranges::any_of(points_at(at), [&](CarvePoint point) {
        const Positions target = geometry_.target(point.layer, point.step);
        return target[0] == at[0] && target[1] == at[1];
    });
}

bool JointFinder::passes_dry(const Positions& at) {
    const std::vector<CarvePoint>& points = points_at(at);
    const bool ended_late = ends_late_;
    ends_late_ = std::ranges::any_of(points, [this](CarvePoint point) { return ends_late(point); });
    return ended_late || !points.empty();
}

const std::vector<CarvePoint>& JointFinder::points_at(const Positions& at) {
    if (place_ == std::pair{at[kPsi], at[kY]}) return points_;
    place_ = {at[kPsi], at[kY]};
    points_.clear();
    look_for_layers(at[kY]);
    for (const std::uint32_t layer : layers_) {
        if (const auto step = geometry_.step_at(layer, at)) points_.push_back({layer, *step});
    }
    return points_;
}

void JointFinder::look_for_layers(std::int64_t y_pulses) {
    if (height_ == y_pulses) return;
    height_ = y_pulses;
    layers_.clear();
    const JobView& job = geometry_.job();
    auto layer = std::upper_bound(
        by_height_.begin(), by_height_.end(), y_pulses,
        [&](std::int64_t height, std::uint32_t above) { return height < job.y_pulses(above, 0); });
    while (layer != by_height_.begin()) {
        --layer;
        if (job.y_pulses(*layer, 0) + most_rise_ < y_pulses) break;
        layers_.push_back(*layer);
    }
}

/// At a point of the job, whose layers are all carved the other way.
bool JointFinder::turns_back(const Positions& from, const Positions& to) {
    const std::int64_t way = to[kPsi] - from[kPsi];
    const std::vector<CarvePoint>& points = points_at(from);
    if (way == 0 || points.empty()) return false;
    return std::ranges::none_of(points, [&](CarvePoint point) {
        const std::uint32_t end = std::max(point.step, 1U);
        const std::int64_t carved =
            geometry_.target(point.layer, end)[kPsi] - geometry_.target(point.layer, end - 1)[kPsi];
        return (carved > 0) == (way > 0);
    });
}

/// A head is the long axis of the line to this point.
bool JointFinder::ends_late(CarvePoint point) const noexcept {
    if (point.step == 0) return false;
    const Positions from = geometry_.target(point.layer, point.step - 1);
    const Positions to = geometry_.target(point.layer, point.step);
    const auto way = [&](std::size_t axis) { return std::abs(to[axis] - from[axis]); };
    return std::max(way(0), way(1)) > std::max(way(kPsi), way(kY));
}

}  // namespace psicarve::verify
