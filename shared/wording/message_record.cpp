// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/wording/message_record.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include "shared/base/shared_text.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve {
namespace {

const Wording* row_named(std::string_view name, const std::vector<Wording>& rows) {
    const auto found = std::ranges::find_if(rows, [&](const Wording& row) { return row.name == name; });
    return found == rows.end() ? nullptr : &*found;
}

/// Takes a number from the front. Nothing: there is none.
std::optional<std::uint64_t> take_number(std::string_view& text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.starts_with(' ')) text.remove_prefix(1);
    return number;
}

}  // namespace

std::string arguments_text(const Message& message) {
    std::string text;
    if (!is_sound(message)) return text;
    for (std::size_t i = 0; i < message.argument_count; ++i) {
        std::array<char, 16> digits{};
        const auto [end, error] =
            std::to_chars(digits.data(), digits.data() + digits.size(), message.arguments[i].bits, 16);
        text.append(i == 0 ? "" : " ").append(digits.data(), end);
    }
    return text;
}

std::optional<Message> message_from(std::string_view name, std::string_view arguments,
                                    std::string_view text) {
    const std::vector<Wording> rows = wordings();
    const Wording* const row = row_named(name, rows);
    if (row == nullptr) return std::nullopt;
    Message message{};
    message.id = row->id;
    for (std::size_t i = 0; i < row->argument_count(); ++i) {
        const auto bits = take_number(arguments);
        if (!bits) return std::nullopt;
        message.arguments[message.argument_count++] = argument(row->arguments[i].kind, *bits);
    }
    if (!arguments.empty()) return std::nullopt;
    text_into_field(message.text, std::string{text});
    if (!is_sound(message)) return std::nullopt;
    return message;
}

}  // namespace psicarve
