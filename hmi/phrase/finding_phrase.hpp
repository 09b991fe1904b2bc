// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// What `psicarve doctor` says, in words that can be translated; what is not known, as it is.
Phrase finding_phrase(const std::string& text);

}  // namespace psicarve::session
