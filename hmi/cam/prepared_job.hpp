// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "shared/job.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"
#include "shared/snapshot_file.hpp"

namespace psicarve::cam {

/// A job in memory, checked against the machine it is for.
struct PreparedJob {
    std::vector<std::byte> blob;
    JobView view;  ///< into `blob`: move, never copy
    Profile profile;
    std::vector<std::string> warnings;  ///< of the slicer
    std::vector<std::string> notes;
    double least_seconds = 0.0;  ///< that carving it takes; 0: nobody has asked (least_time.hpp)

    PreparedJob() = default;
    PreparedJob(PreparedJob&&) = default;
    PreparedJob& operator=(PreparedJob&&) = default;
};

/// Checks the blob's structure, and that a machine with this profile can carve it. "FILE: what is wrong".
Result<PreparedJob> prepare_blob(std::vector<std::byte> blob, Profile profile, const std::string& path);
/// The job of a snapshot that was loaded, for the machine it was made for.
Result<PreparedJob> prepare_snapshot(Snapshot snapshot, const std::string& path);

}  // namespace psicarve::cam
