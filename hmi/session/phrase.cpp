// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/phrase.hpp"

namespace psicarve::session {

std::string filled_in(const std::string& words, const std::vector<std::string>& arguments) {
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

std::string in_english(const Phrase& text) {
    return filled_in(text.english, text.arguments);
}

}  // namespace psicarve::session
