// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/report/exit_code.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

using report::error_json;
using report::exit_code_of;
using report::kExitBadInput;
using report::kExitDifference;
using report::kExitDone;
using report::kExitMachine;
using report::kExitUsage;

/// The one way in which a command reports its failure: "psicarve: ..." on standard error and, for a program
/// that reads the output (--json), the same as one object on standard output. Returns the exit code.
int report_error(const Error& error, bool as_json);

/// "psicarve: warning: ..." on standard error.
void print_warning(const std::string& text);
/// "psicarve: ..." on standard error: progress, for people.
void print_note(const std::string& text);
/// "psicarve: ..." on standard error, with the answer on the same line.
void print_question(const std::string& text);
/// "psicarve: ..." on standard error, for an error that a report on standard output has already given to
/// programs.
void print_error(const Error& error);

/// Makes sure that the output has reached its reader: a full disk behind `>` is an error, not a success.
Result<void> flush_output();

}  // namespace psicarve::cli
