// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/manual/command_table.hpp"

namespace psicarve::manual {

/// The options of psicarve-hmi: its parser, --help, manual page and completion all use this.
const CommandTable& window_table();
/// The option of this name, as "--segment"; null: there is none.
const OptionRow* window_option(const std::string& name);
/// What psicarve-hmi --help prints.
std::string window_help();

}  // namespace psicarve::manual
