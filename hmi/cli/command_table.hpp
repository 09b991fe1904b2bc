// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/manual/command_table.hpp"

namespace CLI {
class App;
}

namespace psicarve::cli {

/// What the parser knows of a program or a command, and of those below it: what it prints with --help.
manual::CommandTable table_of(const CLI::App& app);

}  // namespace psicarve::cli
