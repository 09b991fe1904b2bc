// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shared/profile/profile.hpp"

namespace psicarve::machine {

/// The profile in a file: TOML, or that of the job in a job or snapshot file. Errors: what is wrong with the
/// file.
Result<Profile> profile_in(const std::string& path);

/// The profile with this hash, the one that the core in that process uses: from the file that its command
/// line names, or one of the default places. Nothing where none of them has it (any more). Reads files, whose
/// disk may hang: any thread.
std::optional<Profile> find_core_profile(std::uint32_t core_pid, std::uint64_t hash);

/// The file of --profile in a command line as /proc shows it, relative to `folder`; empty: it names none.
std::string profile_named_in(const std::string& command_line, const std::string& folder);

}  // namespace psicarve::machine
