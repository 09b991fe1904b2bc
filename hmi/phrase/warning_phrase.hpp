// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// A warning of the reader or the slicer, in words that can be translated and that name the window's fields
/// where the command line has options. One that is not known stays as it is.
Phrase warning_phrase(const std::string& warning);

/// Those of `more` that are not among `known`: a job has its mesh's warnings, too.
std::vector<std::string> other_warnings(const std::vector<std::string>& more,
                                        const std::vector<std::string>& known);

}  // namespace psicarve::session
