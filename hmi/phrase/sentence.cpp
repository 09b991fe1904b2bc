// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/sentence.hpp"

#include <string>
#include <utility>

namespace psicarve::session {
namespace {

/// What stands for %1, %2 ... when the text is such a sentence.
std::optional<std::vector<std::string>> arguments_of(std::string_view said, std::string_view text) {
    std::vector<std::string> arguments;
    for (;;) {
        const std::size_t mark = said.find('%');
        const std::string_view before = said.substr(0, mark);
        if (!text.starts_with(before)) return std::nullopt;
        text.remove_prefix(before.size());
        if (mark == std::string_view::npos) break;
        said.remove_prefix(mark + 2);
        const std::string_view after = said.substr(0, said.find('%'));
        const std::size_t end = after.empty() ? text.size() : text.find(after);
        if (end == std::string_view::npos) return std::nullopt;
        arguments.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    if (!text.empty()) return std::nullopt;
    return arguments;
}

}  // namespace

std::optional<Phrase> phrase_for(const std::vector<Sentence>& sentences, std::string_view text) {
    for (const Sentence& sentence : sentences) {
        auto arguments = arguments_of(sentence.said, text);
        if (!arguments) continue;
        Phrase shown = sentence.shown;
        shown.arguments = std::move(*arguments);
        return shown;
    }
    return std::nullopt;
}

std::vector<Sentence> as_said(const std::vector<Phrase>& phrases) {
    std::vector<Sentence> sentences;
    sentences.reserve(phrases.size());
    for (const Phrase& one : phrases) sentences.push_back({one.english, one});
    return sentences;
}

}  // namespace psicarve::session
