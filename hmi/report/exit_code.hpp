// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/base/result.hpp"

namespace psicarve::report {

// How a program tells other programs that it failed.
inline constexpr int kExitDone = 0;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitBadInput = 3;
inline constexpr int kExitMachine = 4;
inline constexpr int kExitNoCore = 5;
inline constexpr int kExitDifference = 6;

/// The exit code of the command line for an error.
int exit_code_of(ErrorCode code) noexcept;

/// {"error": {...}} without printing it; with the identifier and arguments of its message, where it has one.
std::string error_json(const Error& error);
/// For a command that ends with another exit code than the error's own.
std::string error_json(const Error& error, int exit_code);

}  // namespace psicarve::report
