// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/job_pulses.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "shared/base/units.hpp"
#include "shared/job/outside.hpp"

namespace psicarve::cam {
namespace {

using Place = std::array<std::int64_t, kAxisCount>;

/// The layer's point that is carved as its `step`-th.
Place place_of(const JobView& job, std::uint32_t layer, std::uint32_t step) {
    const std::uint32_t point = carved_point(job.joining(), job.point_count(), layer, step);
    Place place{};
    place[index_of(Axis::r1)] = job.r_left_pulses(layer)[point];
    place[index_of(Axis::r2)] = job.r_right_pulses(layer)[point];
    place[index_of(Axis::psi)] = job.psi_pulses(layer, point);
    place[index_of(Axis::y)] = job.y_pulses(layer, point);
    return place;
}

void add_way(PulseCounts& sum, const Place& from, const Place& to) {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        sum[axis] += static_cast<std::uint64_t>(std::abs(to[axis] - from[axis]));
}

/// Pulses along the layer in its carving order.
PulseCounts along(const JobView& job, std::uint32_t layer, std::uint32_t from_step, std::uint32_t to_step) {
    PulseCounts sum{};
    Place before = place_of(job, layer, from_step);
    for (std::uint32_t step = from_step + 1; step <= to_step; ++step) {
        const Place now = place_of(job, layer, step);
        add_way(sum, before, now);
        before = now;
    }
    return sum;
}

/// The positions at which each head clears the blank all round.
std::array<std::int64_t, 2> clear_of_blank(const JobView& job, const Profile& profile) {
    const std::array tips_mm{profile.r1.tip_mm(), profile.r2.tip_mm()};
    std::array<AxisMotion, 2> heads{axis_motion(profile, Axis::r1), axis_motion(profile, Axis::r2)};
    const double largest_mm = assumed_blank_mm(job, outside_rule(profile).heads, profile.blank.reach_mm());
    std::array<std::int64_t, 2> clear{};
    for (std::size_t h = 0; h < heads.size(); ++h) {
        const double scale = heads[h].pulses_per_unit;
        clear[h] = std::min(
            pulses_from_mm(largest_mm - tips_mm[h], scale) + pulses_from_mm(profile.job.clearance_mm, scale),
            heads[h].travel_max_pulses);
    }
    return clear;
}

}  // namespace

std::vector<PulseCounts> link_pulses(const JobView& job, const Profile& profile) {
    std::vector<PulseCounts> links(job.layer_count());
    const std::array<std::int64_t, 2> clear = clear_of_blank(job, profile);
    for (std::uint32_t layer = 1; layer < job.layer_count(); ++layer) {
        Place from = place_of(job, layer - 1, job.point_count() - 1);
        const Place to = place_of(job, layer, 0);
        if (job.begins_pass(layer)) {
            Place outside = from;
            for (const Axis head : {Axis::r1, Axis::r2}) {
                const std::size_t h = index_of(head);
                outside[h] = std::max(outside[h], clear[head == Axis::r1 ? 0 : 1]);
            }
            add_way(links[layer], from, outside);
            from = outside;
        }
        add_way(links[layer], from, to);
    }
    return links;
}

std::vector<PulseCounts> pulses_to_end(const JobView& job, const Profile& profile) {
    std::vector<PulseCounts> to_end(job.layer_count());
    const std::vector<PulseCounts> links = link_pulses(job, profile);
    PulseCounts sum{};
    for (std::uint32_t layer = job.layer_count(); layer-- > 0;) {
        const PulseCounts own = along(job, layer, 0, job.point_count() - 1);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum[axis] += own[axis];
        to_end[layer] = sum;
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum[axis] += links[layer][axis];
    }
    return to_end;
}

PulseCounts pulses_to_go(const JobView& job, const std::vector<PulseCounts>& to_end, std::uint32_t layer,
                         std::uint32_t point) {
    PulseCounts left = to_end[layer];
    const std::uint32_t step = carved_point(job.joining(), job.point_count(), layer, point);
    const PulseCounts done = along(job, layer, 0, step);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) left[axis] -= done[axis];
    return left;
}

}  // namespace psicarve::cam
