// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

/// A job in the core's own memory that this machine can carve: bytes and the checked view of them.
struct LoadedJob {
    std::uint64_t generation;
    std::uint64_t checksum;  ///< XXH3 over the blob
    std::vector<std::byte> blob;
    JobView view;
    Message remark;  ///< what is to be known of it before it is carved; mostly none
};

/// Checks a blob completely: its own structure, the machine's limits, and the profile it was made for.
/// Refuses a job made for another machine, with the keys that differ.
Result<std::shared_ptr<const LoadedJob>> load_job(std::vector<std::byte> blob, std::uint64_t generation,
                                                  const Profile& core_profile);

}  // namespace psicarve::supervisor
