// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "hmi/phrase/phrase.hpp"
#include "shared/base/result.hpp"
#include "shared/message/message.hpp"

namespace psicarve::session {

/// A message in words that can be translated, without the name of the command, which the window has its own
/// words for, and with the window's names of axes: "R1". What is not sound, or of another version, is said to
/// be so.
Phrase message_phrase(const psicarve::Message& message);

/// Why the core refused something, or could not be asked. An error that has no message stays as it is.
Phrase core_phrase(const Error& error);

/// "Hold: not while ready; start first".
inline Phrase refusal_phrase(Phrase name, const Error& error) {
    return joined(std::move(name), core_phrase(error));
}

}  // namespace psicarve::session
