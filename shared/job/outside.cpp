// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/job/outside.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace psicarve {
namespace {

// Used where a profile has less: a blank is not turned, nor its centre found, to tenths of a millimetre.
constexpr double kLeastClearance_mm = 0.5;

HeadScale head_scale(const LinearAxisProfile& axis) {
    return {axis.pulses_per_mm, axis.tip_mm()};
}

bool is_told(const JobView& job) noexcept {
    const std::span<const JobPass> passes = job.passes();
    return passes.size() > 1 &&
           std::all_of(passes.begin(), passes.end(), [](const JobPass& pass) { return pass.clear_mm > 0.0; });
}

/// Whether either head comes in from outside anywhere in a pass: a job that does not is in error about its
/// blank.
bool cuts_something(const JobView& job, const JobPass& pass, const HeadsOutside& outside) noexcept {
    for (std::uint32_t layer = pass.first_layer; layer < pass.first_layer + pass.layer_count; ++layer) {
        const auto left = job.r_left_pulses(layer);
        const auto right = job.r_right_pulses(layer);
        if (*std::min_element(left.begin(), left.end()) < outside.from_pulses[0]) return true;
        if (*std::min_element(right.begin(), right.end()) < outside.from_pulses[1]) return true;
    }
    return false;
}

}  // namespace

OutsideRule outside_rule(const Profile& machine) {
    return {{head_scale(machine.r1), head_scale(machine.r2)},
            std::max(machine.job.clearance_mm, kLeastClearance_mm),
            machine.job.path_tolerance_mm,
            machine.blank.reach_mm()};
}

double assumed_blank_mm(const JobView& job, const std::array<HeadScale, 2>& heads, double blank_mm) noexcept {
    double most_mm = blank_mm;
    for (const JobPass& pass : job.passes()) most_mm = std::max(most_mm, pass.clear_mm);
    for (const Axis head : {Axis::r1, Axis::r2})
        most_mm = std::max(most_mm, heads[index_of(head)].real_mm(job.max_radius_pulses(head)));
    return most_mm;
}

double known_blank_mm(const JobView& job, const OutsideRule& rule) {
    const Result<Profile> profile = job_profile(job);
    if (!profile || !is_told(job)) return 0.0;
    double most_mm = std::max(profile->blank.reach_mm(), rule.machine_blank_mm);
    for (const JobPass& pass : job.passes()) most_mm = std::max(most_mm, pass.clear_mm);
    for (const Axis head : {Axis::r1, Axis::r2})
        most_mm =
            std::max(most_mm, rule.heads[index_of(head)].real_mm(job.max_finishing_radius_pulses(head)));
    return most_mm;
}

HeadsOutside heads_outside(double standing_mm, const OutsideRule& rule) noexcept {
    HeadsOutside outside;
    // No machine is larger, and every sum with it stays exact.
    constexpr double kMostPulses = 1e15;
    if (!(standing_mm > 0.0)) return outside;
    for (std::size_t head = 0; head < outside.from_pulses.size(); ++head) {
        const HeadScale& scale = rule.heads[head];
        const double tip_mm = standing_mm + rule.clearance_mm + rule.path_tolerance_mm;
        const double counted = std::ceil((tip_mm - scale.tip_mm) * scale.pulses_per_mm) + 1.0;
        if (counted < kMostPulses) outside.from_pulses[head] = static_cast<std::int64_t>(counted);
    }
    return outside;
}

HeadsOutside heads_outside(const JobView& job, const OutsideRule& rule) {
    const HeadsOutside outside = heads_outside(known_blank_mm(job, rule), rule);
    // If a whole pass would be in the air, the job is wrong about its blank.
    const std::span<const JobPass> passes = job.passes();
    const bool is_true = std::all_of(passes.begin(), passes.end(),
                                     [&](const JobPass& pass) { return cuts_something(job, pass, outside); });
    return is_true ? outside : HeadsOutside{};
}

}  // namespace psicarve
