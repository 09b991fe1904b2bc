// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/phrase/sentence.hpp"

namespace psicarve::session {

// What the readers of drawings, pictures and tables say.

/// After the name of a file.
std::vector<Sentence> flat_refusals();
/// After the number of a line.
std::vector<Sentence> flat_line_refusals();
std::vector<Sentence> flat_warnings();
/// After the number of a line.
std::vector<Sentence> flat_line_warnings();

}  // namespace psicarve::session
