// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/cli/command_set.hpp"
#include "shared/base/result.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::cli {

struct ReplayProgramOptions {
    std::string snapshot;  ///< its file
    std::string program;   ///< file with the text that was run
    std::string trace;     ///< empty: none
};

/// Runs the program of a snapshot again, on a core of its own, as it was recorded. Prints the report and
/// returns the exit code.
Result<int> replay_program(const CommonOptions& common, const ReplayProgramOptions& options,
                           const Snapshot& snapshot);

}  // namespace psicarve::cli
