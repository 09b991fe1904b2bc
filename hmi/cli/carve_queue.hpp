// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Carves one workpiece after the other. Between two of them the operator has to change the blank, and
/// confirms it at the terminal: without that nothing moves. `unattended`: asks no question. The first that
/// does not end with 0 is the last, and so is one in which the operator broke off, even if too late for it.
/// Errors: bad_usage when there is no terminal to ask at, before anything is carved; cancelled.
Result<int> carve_in_turn(const std::vector<std::string>& paths, bool unattended,
                          const std::function<Result<int>(const std::string&)>& carve_one);

}  // namespace psicarve::cli
