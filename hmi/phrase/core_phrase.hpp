// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// Why the core refused something, or could not be asked, in words that can be translated; without the name
/// of the command, which the window has its own words for. What is not known stays as it is.
Phrase core_phrase(const std::string& reason);

/// "Hold: not while ready; start first".
inline Phrase refusal_phrase(Phrase name, const std::string& reason) {
    return joined(std::move(name), core_phrase(reason));
}

}  // namespace psicarve::session
