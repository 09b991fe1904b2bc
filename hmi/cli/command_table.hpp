// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/manual/command_table.hpp"

namespace CLI {
class App;
}

namespace psicarve::cli {

/// The parser's description of a program or a command, and of those below it: the content of --help.
manual::CommandTable table_of(const CLI::App& app);

}  // namespace psicarve::cli
