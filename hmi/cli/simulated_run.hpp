// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hmi/cli/carved_piece.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/machine/core_process.hpp"
#include "hmi/machine/job_run.hpp"
#include "hmi/machine/verified_core.hpp"
#include "hmi/verify/asked_carving.hpp"

namespace psicarve::cli {

struct SimulatedRun {
    /// Lets the core work; returns the outcome as the core reports it.
    std::function<machine::JobRun(machine::VerifiedCore&, const machine::StatusWatch&)> run;
    std::string picture_path;  ///< empty: no picture
    bool as_json = false;
    const std::unique_ptr<CarvedPiece>* piece = nullptr;  ///< null: no piece is wanted
    /// Of a recording, whose own starts are repeated; nothing: the whole job is to be carved.
    std::optional<verify::AskedCarving> asked{};
};

/// Carves or replays on a core of our own: starts it, runs, ends it, judges its pins, draws the picture,
/// prints the report. Returns the exit code.
Result<int> simulated_run(machine::CoreLaunch launch, const PreparedJob& job, const SimulatedRun& what);

}  // namespace psicarve::cli
