// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "hmi/cli/command_set.hpp"
#include "hmi/cli/program_watch.hpp"
#include "hmi/verify/program/program_verifier.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// What the pins of a program's run came to.
struct PinsVerdict {
    std::optional<verify::ProgramVerifyReport> verification;
    std::string unverified_reason;  ///< where they were not judged
    std::string trace_path;         ///< of the file that was written; empty: none
    bool is_simulated = false;      ///< they are those of no real machine
};
/// Of a program's run.
struct PinsWork {
    /// Before the first record is written, once the program is known to be right; empty: nothing is to be
    /// done.
    std::function<Result<void>()> begin;
    /// Once the program is run to its end, when the machine is no longer needed. An error: a trace that was
    /// asked for is not there.
    std::function<Result<PinsVerdict>(const ProgramRun& run)> judge;
};

/// The report of a program that was run to its end, and the exit code.
int report_program_run(const CommonOptions& common, const std::string& name, const ProgramRun& run,
                       const PinsVerdict& pins);

}  // namespace psicarve::cli
