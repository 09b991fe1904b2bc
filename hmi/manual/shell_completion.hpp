// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/manual/command_table.hpp"

namespace psicarve::manual {

// Scripts that complete the words after a program's name: commands, options and their values. Equal tables
// give equal bytes.

std::string bash_completion(const CommandTable& program);
std::string zsh_completion(const CommandTable& program);
std::string fish_completion(const CommandTable& program);

}  // namespace psicarve::manual
