// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// The data that support needs to find out what went wrong.
struct SupportBundle {
    std::string messages;            ///< of this window
    std::string log_folder;          ///< its log files are copied; empty: none
    std::optional<Profile> profile;  ///< the machine's, if it is known
    std::string versions;            ///< of the programs and what they run on
    std::string segment_name;
    std::string group;
};

/// Makes `folder`/psicarve-support-`stamp` with messages.txt, the log files, profile.toml, snapshot.psi (job,
/// status and flight recorder of the segment) and versions.txt, and returns its path. versions.txt names what
/// could not be had. May take seconds.
Result<std::string> write_support_bundle(const SupportBundle& bundle, const std::string& folder,
                                         const std::string& stamp);

/// Kernel and machine, a line each.
std::string system_text();

}  // namespace psicarve::session
