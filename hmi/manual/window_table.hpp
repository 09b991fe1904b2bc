// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/manual/command_table.hpp"

namespace psicarve::manual {

/// What psicarve-hmi takes: its parser, its --help, its page and its completion go by this.
const CommandTable& window_table();
/// The option of this name, as "--segment"; null: there is none.
const OptionRow* window_option(const std::string& name);
/// What psicarve-hmi --help prints.
std::string window_help();

}  // namespace psicarve::manual
