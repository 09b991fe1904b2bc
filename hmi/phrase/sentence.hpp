// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// What the core, a reader or the slicer says, and what a window shows for it: words that can be translated.
struct Sentence {
    std::string_view said;  ///< %1, %2 ... in their order
    Phrase shown;
};

/// What is shown as it is said.
std::vector<Sentence> as_said(const std::vector<Phrase>& phrases);

/// The phrase of the first sentence that the text is, with what stands there for %1, %2 ...; nothing when it
/// is none of them.
std::optional<Phrase> phrase_for(const std::vector<Sentence>& sentences, std::string_view text);

}  // namespace psicarve::session
