// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/phrase/sentence.hpp"

namespace psicarve::session {

/// Why a program in G-code could not be read or run as a whole. What is wrong in its lines is gcode::Problem.
std::optional<Phrase> program_error_phrase(const std::string& message);
/// The same, where the program's path stands before it.
std::vector<Sentence> program_file_refusals();

}  // namespace psicarve::session
