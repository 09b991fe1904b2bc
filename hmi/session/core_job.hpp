// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "hmi/cam/prepared_job.hpp"
#include "shared/base/result.hpp"

namespace psicarve::session {

/// Publishes, and waits for the core's verdict until it comes or the wait is cancelled.
Result<std::uint64_t> publish_and_wait(const std::string& segment, const std::string& group,
                                       const cam::PreparedJob& job, const std::atomic<bool>& cancels);

/// The job that is published in the segment.
Result<std::shared_ptr<const cam::PreparedJob>> job_in_segment(const std::string& segment,
                                                               const std::string& group);

}  // namespace psicarve::session
