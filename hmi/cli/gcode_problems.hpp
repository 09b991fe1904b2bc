// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "hmi/gcode/problem.hpp"
#include "hmi/gcode/program_check.hpp"

namespace psicarve::cli {

/// As it comes, or as it is kept where it is read whole first.
bool is_standard_input(const std::string& path);

/// A program's name as its user knows it.
std::string program_name(const std::string& path);

/// "1 line", "2 lines".
std::string count_text(std::uint64_t count, const char* one);

/// Warnings and errors on standard error, each with file, line and column; and how many more there are.
void print_problems(const std::string& name, const gcode::ProblemList& problems);

/// The report of a check: file, ok, what was read, and all problems.
nlohmann::ordered_json check_json(const std::string& name, const gcode::ProgramFacts& facts,
                                  const gcode::ProblemList& problems);
void print_json_line(const nlohmann::ordered_json& object);

}  // namespace psicarve::cli
