// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/wording/wording.hpp"

#include <algorithm>

#include "shared/wording/argument_words.hpp"
#include "shared/wording/wording_tables.hpp"

namespace psicarve {
namespace {

std::string filled_in(std::string_view words, const std::vector<std::string>& arguments) {
    std::string text;
    for (std::size_t mark = words.find('%'); mark != std::string_view::npos; mark = words.find('%')) {
        text += words.substr(0, mark);
        const auto which = static_cast<std::size_t>(words[mark + 1] - '1');
        text += arguments.at(which);
        words.remove_prefix(mark + 2);
    }
    return text += words;
}

}  // namespace

std::size_t Wording::argument_count() const noexcept {
    std::size_t count = 0;
    while (count < kMessageArguments && arguments[count].kind != ArgumentKind::none) ++count;
    return count;
}

std::vector<Wording> wordings() {
    std::vector<Wording> all;
    for (const auto& part : {command_wordings(), job_wordings(), program_wordings()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

const Wording* wording_of(MessageId id) noexcept {
    for (const auto& part : {command_wordings(), job_wordings(), program_wordings()}) {
        const auto found = std::ranges::lower_bound(part, id, {}, &Wording::id);
        if (found != part.end() && found->id == id) return &*found;
    }
    return nullptr;
}

std::string_view name_of(MessageId id) noexcept {
    const Wording* const row = wording_of(id);
    return row != nullptr ? row->name : "unknown";
}

bool is_sound(const Message& message) noexcept {
    const Wording* const row = wording_of(message.id);
    if (row == nullptr || message.argument_count != row->argument_count()) return false;
    for (std::size_t i = 0; i < message.argument_count; ++i) {
        if (message.arguments[i].kind != row->arguments[i].kind) return false;
        if (!is_sound(message.arguments[i])) return false;
    }
    return true;
}

std::vector<std::string> argument_words(const Message& message) {
    std::vector<std::string> words;
    if (!is_sound(message)) return words;
    const int mm_digits = wording_of(message.id)->mm_digits;
    for (std::size_t i = 0; i < message.argument_count; ++i)
        words.push_back(words_of(message.arguments[i], message, mm_digits));
    return words;
}

std::string in_words(const Message& message) {
    if (message.is_none()) return {};
    std::string words;
    if (is_sound(message)) {
        const Wording& row = *wording_of(message.id);
        const std::vector<std::string> arguments = argument_words(message);
        const std::string remedy = filled_in(row.remedy, arguments);
        words = filled_in(row.sentence, arguments) + (remedy.empty() ? "" : "; ") + remedy;
    }
    // An empty text alone is as little as damage.
    if (!words.empty()) return words;
    const auto number = static_cast<unsigned>(message.id);
    return "message " + std::to_string(number) + " is not known to this version, or damaged";
}

std::string in_words(const std::vector<Message>& messages) {
    std::string words;
    for (const Message& one : messages) words += (words.empty() ? "" : "; ") + in_words(one);
    return words;
}

Error error_from(ErrorCode code, const Message& message) {
    return Error{code, in_words(message), message};
}

}  // namespace psicarve
