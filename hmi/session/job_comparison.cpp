// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_comparison.hpp"

#include "hmi/session/start_place.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// Makes the checksum only when it is needed: a large job takes a while.
bool JobComparison::is_of_checkpoint(const JobPointer& job, const MachineView& machine) {
    const bool is_known = place_to_go_on(machine) || machine.earlier_layer;
    if (machine.is_heard() || !is_known || !job || job->view.layer_count() != machine.checkpoint_layer_count)
        return false;
    if (summed_ != job) sum_ = job_checksum(job->blob);
    summed_ = job;
    return sum_ == machine.checkpoint_job_checksum;
}

void JobComparison::compare_profiles(const JobPointer& job, const MachineView& machine, OpenJobView& view) {
    const std::uint64_t hash = machine.profile ? machine.core_profile_hash : 0;
    if (compared_ == job && compared_hash_ == hash) return;
    compared_ = job;
    compared_hash_ = hash;
    view.profile_difference.clear();
    view.blank_difference.reset();
    if (!job || !machine.profile) return;
    view.blank_difference = blank_difference(job->profile.blank, machine.profile->blank);
    const auto differences = job_differences(job->profile, *machine.profile);
    if (!differences.empty()) view.profile_difference = differences.front();
}

}  // namespace psicarve::session
