// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::verify {

/// Whether the file begins like a binary pin trace. One that cannot be read does not.
bool is_binary_trace(const std::string& path);

/// The blob of the first job that a trace in a file carries: its checksum is right, nothing else was looked
/// at. Nothing: it carries none, as dumps and older traces do. The trace is read up to the job and no
/// further. "FILE: what is wrong" when the job is damaged, and when the trace is before it has come to one.
Result<std::optional<std::vector<std::byte>>> first_carried_job(const std::string& path);

/// The same, for who can do nothing without: "FILE: carries no job", and what to do about it: `remedy`.
Result<std::vector<std::byte>> require_carried_job(const std::string& path, const std::string& remedy);

/// As first_carried_job(), but all of the trace is read: bad_input "FILE: carries several jobs", and what to
/// do about it: `remedy`.
Result<std::optional<std::vector<std::byte>>> only_carried_job(const std::string& path,
                                                               const std::string& remedy);

/// Whether a job may be this trace's: the trace carries it, or none. Else bad_input that names both.
/// One that does not match its own checksum is no other job. `checksum`: job_checksum() of its blob;
/// `job_path`: the file it is from. What is damaged in the trace is left for its reader to tell.
Result<void> check_is_of_trace(const std::string& trace_path, std::uint64_t checksum,
                               const std::string& job_path);

}  // namespace psicarve::verify
