// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Reads standard input to its end into memory. Returns a name under which this process, and those that it
/// starts, can read it as a regular file, as often as they want. Errors: bad_input, also beyond 1 GiB.
Result<std::string> file_of_standard_input();

/// Whether an output's name means standard output.
bool is_standard_output(const std::string& name);
/// Refuses bytes for a terminal, or beside a report. bad_usage.
Result<void> check_standard_output(const std::string& name, bool as_json);

}  // namespace psicarve::cli
