// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/result.hpp"

namespace psicarve::cli {

inline constexpr int kExitDone = 0;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitBadInput = 3;
inline constexpr int kExitMachine = 4;
inline constexpr int kExitDifference = 6;

/// The exit code of the command line for an error.
int exit_code_of(ErrorCode code) noexcept;

/// The one way in which a command says that it failed: "psicarve: ..." on standard error and, for a program
/// that reads us (--json), the same as one object on standard output. Returns the exit code.
int report_error(const Error& error, bool as_json);

/// {"error": {...}} without printing it.
std::string error_json(const Error& error);
/// Where the command ends with another exit code than the error's own.
std::string error_json(const Error& error, int exit_code);

/// "psicarve: warning: ..." on standard error.
void print_warning(const std::string& text);
/// "psicarve: ..." on standard error: what goes on, for people.
void print_note(const std::string& text);
/// "psicarve: ..." for what a report on standard output has already said to programs.
void print_error(const Error& error);

/// Makes sure that what was printed has reached its reader: a full disk behind `>` is an error, not a
/// success.
Result<void> flush_output();

}  // namespace psicarve::cli
