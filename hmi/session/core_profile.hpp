// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// The profile with this hash, the one that the core in that process uses: from the file that its command
/// line names, or one of the default places. Nothing where none of them has it (any more). Reads files: any
/// thread.
std::optional<Profile> find_core_profile(std::uint32_t core_pid, std::uint64_t hash);

/// The file of --profile in a command line as /proc shows it, relative to `folder`; empty: it names none.
std::string profile_named_in(const std::string& command_line, const std::string& folder);

/// The first keys in which they differ, with both values: "axis.y.speed_mm_s: core 20.0, here 10.0"; after
/// `most` of them the number of further ones.
std::vector<Phrase> profile_differences(const Profile& core, const Profile& here, std::size_t most);

}  // namespace psicarve::session
