// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// Compares a job with the machine: its profile with the core's, and its checksum with that of the machine's
/// checkpoint. Asked at screen rate, it calculates only when the job or the core's profile has changed.
class JobComparison {
public:
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;

    /// Writes `profile_difference` and `blank_difference`; both empty where there is no job, or no profile.
    void compare_profiles(const JobPointer& job, const MachineView& machine, OpenJobView& view);
    /// Whether the machine's checkpoint is of this job; only where no core is heard.
    bool is_of_checkpoint(const JobPointer& job, const MachineView& machine);

private:
    JobPointer compared_;              ///< the job whose profile was compared last
    std::uint64_t compared_hash_ = 0;  ///< of the core's profile then; 0: none was known
    JobPointer summed_;                ///< the job with the checksum `sum_`
    std::uint64_t sum_ = 0;
};

}  // namespace psicarve::session
