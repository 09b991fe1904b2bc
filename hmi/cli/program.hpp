// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/manual/command_table.hpp"

namespace psicarve::cli {

/// The whole of `psicarve`: reads the command line, does what it says, returns the exit code.
int run(int argc, char** argv);

/// What psicarve takes, as --help tells it.
manual::CommandTable program_table();

}  // namespace psicarve::cli
