// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/approach.hpp"

#include <algorithm>

#include "shared/base/units.hpp"
#include "shared/job/outside.hpp"

namespace psicarve::plan {
namespace {

using cycle::Spindle;

SpeedCaps heads_at(const MachineLimits& limits, double speed_mm_s) {
    SpeedCaps caps{};
    for (std::size_t head = 0; head < kHeads; ++head) {
        caps[head] = speed_mm_s * limits.axes[head].pulses_per_unit;
    }
    return caps;
}

/// The heads' part of a way, of those that move outwards (or inwards) only.
Pulses4 heads_way(const Pulses4& from, const Pulses4& to, bool outwards) {
    Pulses4 way{};
    for (std::size_t head = 0; head < kHeads; ++head) {
        const std::int64_t delta = to[head] - from[head];
        if ((delta > 0) == outwards) way[head] = delta;
    }
    return way;
}

Pulses4 first_point(const JobView& job, std::uint32_t layer, std::uint32_t step = 0) {
    const std::uint32_t point = carved_point(job.joining(), job.point_count(), layer, step);
    return {job.r_left_pulses(layer)[point], job.r_right_pulses(layer)[point], job.psi_pulses(layer, point),
            job.y_pulses(layer, point)};
}

/// Where the heads clear the blank all round.
Pulses4 outside_of(const MachineLimits& limits, const JobView& job) {
    Pulses4 outside{};
    const double largest_mm = assumed_blank_mm(job, limits.outside_rule.heads, limits.blank_radius_mm);
    for (std::size_t k = 0; k < kHeads; ++k) {
        const double counted_mm = largest_mm - limits.tip_offset_mm[k];
        outside[k] =
            std::min(pulses_from_mm(counted_mm, limits.axes[k].pulses_per_unit) + limits.clearance_pulses[k],
                     limits.axes[k].travel_max_pulses);
    }
    return outside;
}

/// Heads outside, then psi the short way, then Y to where `first` is, spindle off.
void add_way_outside(BlockList& list, const MachineLimits& limits, Pulses4 from, const Pulses4& outside,
                     const Pulses4& first) {
    list.outputs(kAllDrives, Spindle::off);
    list.move(heads_way(from, outside, true));
    const std::int64_t turns = turns_to_drop(from[kPsi], first[kPsi], limits.pulses_per_rev);
    if (turns != 0) {
        from[kPsi] -= turns * limits.pulses_per_rev;
        list.define(Axis::psi, from[kPsi]);
    }
    list.move({0, 0, first[kPsi] - from[kPsi], 0});
    list.move({0, 0, 0, first[kY] - from[kY]});
    list.move(heads_way(from, outside, false));
}

void add_arrival(BlockList& list, const MachineLimits& limits, const JobView& job, std::uint32_t layer,
                 std::uint32_t step) {
    list.reach(layer, carved_point(job.joining(), job.point_count(), layer, step));
    // The carving may begin at once, and outwards.
    list.dwell(limits.rest_ticks);
    list.end();
}

}  // namespace

std::int64_t turns_to_drop(std::int64_t from_pulses, std::int64_t to_pulses, std::int64_t pulses_per_rev) {
    const std::int64_t ahead = from_pulses - to_pulses + pulses_per_rev / 2;
    const std::int64_t turns = ahead / pulses_per_rev;
    return ahead % pulses_per_rev < 0 ? turns - 1 : turns;
}

MachineLimits limits_for(MachineLimits limits, const JobView& job) {
    if (const auto profile = job_profile(job)) limits.blank_radius_mm = profile->blank.reach_mm();
    return limits;
}

std::vector<cycle::MotionBlock> approach_blocks(const MachineLimits& limits, const JobView& job,
                                                const Pulses4& from_pulses, std::uint32_t layer,
                                                std::uint32_t step) {
    const Pulses4 outside = outside_of(limits, job);
    const Pulses4 first = first_point(job, layer, step);
    BlockList list(limits);
    add_way_outside(list, limits, from_pulses, outside, first);
    list.outputs(kAllDrives, Spindle::on);
    list.dwell(limits.spinup_ticks);
    Pulses4 plunge{};
    for (std::size_t k = 0; k < kHeads; ++k) plunge[k] = first[k] - outside[k];
    list.move(plunge, heads_at(limits, limits.plunge_mm_s));
    add_arrival(list, limits, job, layer, step);
    return std::move(list.blocks());
}

std::vector<cycle::MotionBlock> dry_approach_blocks(const MachineLimits& limits, const JobView& job,
                                                    const Pulses4& from_pulses, std::uint32_t layer,
                                                    std::uint32_t step) {
    BlockList list(limits);
    add_way_outside(list, limits, from_pulses, outside_of(limits, job), first_point(job, layer, step));
    add_arrival(list, limits, job, layer, step);
    return std::move(list.blocks());
}

void add_way_between_passes(BlockList& list, const MachineLimits& limits, const JobView& job,
                            const Pulses4& from_pulses, std::uint32_t layer) {
    const Pulses4 outside = outside_of(limits, job);
    const Pulses4 first = first_point(job, layer);
    Pulses4 plunge{};
    for (std::size_t k = 0; k < kHeads; ++k) plunge[k] = first[k] - std::max(from_pulses[k], outside[k]);
    // The last point may have been reached inwards, and the carving may go on outwards: a motor turns round
    // at rest.
    list.dwell(limits.rest_ticks);
    list.move(heads_way(from_pulses, outside, true));
    list.move({0, 0, first[kPsi] - from_pulses[kPsi], 0});
    list.move({0, 0, 0, first[kY] - from_pulses[kY]});
    list.move(plunge, heads_at(limits, limits.plunge_mm_s));
    list.reach(layer, carved_point(job.joining(), job.point_count(), layer, 0));
    list.dwell(limits.rest_ticks);
}

std::vector<cycle::MotionBlock> finish_blocks(const MachineLimits& limits, const Pulses4& from_pulses) {
    Pulses4 way{};
    for (std::size_t k = 0; k < kHeads; ++k) {
        const std::int64_t out =
            std::min(from_pulses[k] + limits.retract_pulses[k], limits.axes[k].travel_max_pulses);
        way[k] = std::max<std::int64_t>(0, out - from_pulses[k]);
    }
    BlockList list(limits);
    // The last point may have been reached inwards: stopping and going out again at once would be a jump of
    // twice what a motor can do.
    list.dwell(limits.rest_ticks);
    list.move(way);
    list.outputs(kAllDrives, Spindle::off);
    list.end();
    return std::move(list.blocks());
}

void add_link(BlockList& list, const MachineLimits& limits, const Pulses4& from_pulses,
              const Pulses4& to_pulses, std::uint32_t layer, std::uint32_t point) {
    SpeedCaps caps = heads_at(limits, limits.feed_mm_s);
    caps[kY] = limits.feed_mm_s * limits.axes[kY].pulses_per_unit;
    list.move(heads_way(from_pulses, to_pulses, true), caps);
    list.move({0, 0, to_pulses[kPsi] - from_pulses[kPsi], to_pulses[kY] - from_pulses[kY]}, caps);
    list.move(heads_way(from_pulses, to_pulses, false), caps);
    list.reach(layer, point);
}

}  // namespace psicarve::plan
