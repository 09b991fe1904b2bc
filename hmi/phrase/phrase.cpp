// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/phrase.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "shared/base/printable.hpp"

namespace psicarve::session {

namespace {

std::string with_arguments(std::string_view words, const std::vector<std::string>& arguments) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool is_mark =
            words[i] == '%' && i + 1 < words.size() && words[i + 1] >= '1' && words[i + 1] <= '9';
        if (!is_mark) {
            text += words[i];
            continue;
        }
        const auto index = static_cast<std::size_t>(words[i + 1] - '1');
        if (index < arguments.size()) text += arguments[index];
        ++i;
    }
    return text;
}

}  // namespace

std::string filled_in(const std::string& words, const std::vector<std::string>& arguments) {
    std::vector<std::string> shown;
    shown.reserve(arguments.size());
    for (const std::string& argument : arguments) shown.push_back(printable(argument));
    return with_arguments(words, shown);
}

std::string in_english(const Phrase& text) {
    std::vector<std::string> arguments = text.arguments;
    for (const Phrase& inner : text.inner) arguments.push_back(in_english(inner));
    return filled_in(text.english, arguments);
}

std::string as_told(const Phrase& text) {
    std::vector<std::string> arguments = text.arguments;
    for (const Phrase& inner : text.inner) arguments.push_back(as_told(inner));
    return with_arguments(text.english, arguments);
}

Phrase joined(Phrase before, Phrase after) {
    Phrase both = phrase("%1: %2");  // in Chinese the colon is as wide as its letters
    both.inner = {std::move(before), std::move(after)};
    return both;
}

Phrase listed(std::vector<Phrase> phrases) {
    constexpr std::array kLists{"",
                                "%1",
                                "%1, %2",
                                "%1, %2, %3",
                                "%1, %2, %3, %4",
                                "%1, %2, %3, %4, %5",
                                "%1, %2, %3, %4, %5, %6",
                                "%1, %2, %3, %4, %5, %6, %7",
                                "%1, %2, %3, %4, %5, %6, %7, %8",
                                "%1, %2, %3, %4, %5, %6, %7, %8, %9"};
    if (phrases.size() >= kLists.size()) phrases.resize(kLists.size() - 1);
    return Phrase{kLists[phrases.size()], {}, std::move(phrases)};
}

}  // namespace psicarve::session
