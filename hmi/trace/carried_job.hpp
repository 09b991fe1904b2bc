// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::verify {

/// Whether the file begins like a binary pin trace. False for a file that cannot be read.
bool is_binary_trace(const std::string& path);

/// The blob of the first job that a trace in a file carries: only its checksum was checked. Nothing: it
/// carries none, as dumps and older traces do. Reads the trace only up to the job. "FILE: what is wrong" when
/// the job, or the trace before it, is damaged.
Result<std::optional<std::vector<std::byte>>> first_carried_job(const std::string& path);

/// The same, for callers that need a job: else "FILE: carries no job", and what to do about it: `remedy`.
Result<std::vector<std::byte>> require_carried_job(const std::string& path, const std::string& remedy);

/// As first_carried_job(), but reads the whole trace: bad_input "FILE: carries several jobs", and what to do
/// about it: `remedy`.
Result<std::optional<std::vector<std::byte>>> only_carried_job(const std::string& path,
                                                               const std::string& remedy);

/// Whether a job may be this trace's: the trace carries it, or none. Else bad_input that names both. A job in
/// the trace that does not match its own checksum counts as damaged, not as another job. `checksum`:
/// job_checksum() of its blob; `job_path`: the file it is from. Damage in the trace is left for its reader to
/// report.
Result<void> check_is_of_trace(const std::string& trace_path, std::uint64_t checksum,
                               const std::string& job_path);

}  // namespace psicarve::verify
