// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/outside.hpp"

#include <cmath>
#include <span>

namespace psicarve {
namespace {

// Where a profile asks for less: a blank is not turned, nor its centre found, to tenths of a millimetre.
constexpr double kLeastClearance_mm = 0.5;

HeadScale head_scale(const LinearAxisProfile& axis) {
    return {axis.pulses_per_mm, axis.tip_mm()};
}

bool is_told(const JobView& job, double blank_mm) noexcept {
    const std::span<const JobPass> passes = job.passes();
    return blank_mm > 0.0 ||
           std::all_of(passes.begin(), passes.end(), [](const JobPass& pass) { return pass.clear_mm > 0.0; });
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
    const bool is_known = is_told(job, blank_mm);
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const std::int32_t counted =
            is_known ? job.max_finishing_radius_pulses(head) : job.max_radius_pulses(head);
        most_mm = std::max(most_mm, heads[index_of(head)].real_mm(counted));
    }
    return most_mm;
}

double known_blank_mm(const JobView& job, const OutsideRule& rule) {
    const Result<Profile> profile = job_profile(job);
    if (!profile || !is_told(job, profile->blank.reach_mm())) return 0.0;
    return std::max(assumed_blank_mm(job, rule.heads, profile->blank.reach_mm()), rule.machine_blank_mm);
}

HeadsOutside heads_outside(double standing_mm, const OutsideRule& rule) noexcept {
    HeadsOutside outside;
    // No machine is so large, and every sum with it stays exact.
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
    // Of one pass alone none is further out than what it makes.
    if (job.passes().size() < 2) return {};
    return heads_outside(known_blank_mm(job, rule), rule);
}

}  // namespace psicarve
