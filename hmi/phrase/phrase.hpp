// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

/// Marks a text that becomes part of a phrase elsewhere: scripts/translations.py looks for it.
#define PSICARVE_TEXT(english) english

namespace psicarve::session {

/// A text for the operator that can still be translated: English words with %1, %2 ... and what stands there.
/// `english` is a literal. Arguments are numbers with their units, names of axes and files, words of the
/// core. Phrases in `inner` stand at the marks after those of the arguments.
struct Phrase {
    const char* english = "";
    std::vector<std::string> arguments{};
    std::vector<Phrase> inner{};

    bool is_empty() const noexcept { return *english == '\0'; }
    friend bool operator==(const Phrase& a, const Phrase& b) {
        return std::string{a.english} == b.english && a.arguments == b.arguments && a.inner == b.inner;
    }
};

template <typename... Arguments>
Phrase phrase(const char* english, Arguments&&... arguments) {
    return Phrase{english, {std::string{std::forward<Arguments>(arguments)}...}, {}};
}

/// "Hold: nothing is carved".
Phrase joined(Phrase before, Phrase after);
/// Those that are told, with commas; up to nine.
Phrase listed(std::vector<Phrase> phrases);

/// The words with their arguments in place.
std::string in_english(const Phrase& text);
/// The same with all bytes that others gave, also those that would steer a terminal: for JSON, and for those
/// who make them printable at the end.
std::string as_told(const Phrase& text);
/// The same with words that were translated: `words` instead of text.english.
std::string filled_in(const std::string& words, const std::vector<std::string>& arguments);

}  // namespace psicarve::session
