// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "hmi/cam/job_pulses.hpp"
#include "hmi/cam/least_time.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::cam {

/// A job in memory, checked against the machine it is for.
struct PreparedJob {
    std::vector<std::byte> blob;
    JobView view;  ///< into `blob`: move, never copy
    Profile profile;
    std::shared_ptr<const model::Mesh> mesh;  ///< the mesh that it was sliced from, if asked for
    std::vector<std::string> warnings;        ///< of the slicer, and of a profile with another blank
    std::vector<std::string> notes;
    std::vector<PulseCounts> pulses_to_end;  ///< by layer; empty: not calculated (job_pulses.hpp)
    LeastTime least;                         ///< of its carving, if calculated

    PreparedJob() = default;
    PreparedJob(PreparedJob&&) = default;
    PreparedJob& operator=(PreparedJob&&) = default;
};

/// Checks the blob's structure, and whether a machine with this profile can carve it. "FILE: what is wrong".
Result<PreparedJob> prepare_blob(std::vector<std::byte> blob, Profile profile, const std::string& path);
/// The job of a loaded snapshot, for the machine it was made for.
Result<PreparedJob> prepare_snapshot(Snapshot snapshot, const std::string& path);
/// The same job for another machine, carved from its own blank: warns where that machine's profile has
/// another.
Result<PreparedJob> prepare_for(PreparedJob job, Profile machine, const std::string& path);

}  // namespace psicarve::cam
