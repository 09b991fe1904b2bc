// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// Why a file could not be read, a model not sliced or a job not published, in words that can be translated
/// and that name the window's fields where the command line has options. What is not known stays as it is.
Phrase error_phrase(const std::string& message);

}  // namespace psicarve::session
