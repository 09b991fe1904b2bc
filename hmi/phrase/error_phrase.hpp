// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/phrase/phrase.hpp"
#include "shared/base/result.hpp"

namespace psicarve::session {

/// Why a file could not be read, a model not sliced or a job not published, in words that can be translated
/// and that name the window's fields where the command line has options. What is not known stays as it is.
Phrase error_phrase(const std::string& message);
/// By its message, where it has one.
Phrase error_phrase(const Error& error);

}  // namespace psicarve::session
