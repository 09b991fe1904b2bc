// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/manual/command_table.hpp"

namespace psicarve::cli {

/// The whole of `psicarve`: reads the command line, runs the command, returns the exit code.
int run(int argc, char** argv);

/// The commands and options of psicarve, as --help describes them.
manual::CommandTable program_table();

}  // namespace psicarve::cli
