// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/message/message.hpp"

namespace psicarve {

/// An argument's kind, and its name for programs: "from_mm".
struct ArgumentName {
    ArgumentKind kind = ArgumentKind::none;
    const char* name = "";
};

/// A message's row in the one table of English words. %1, %2 ... stand for the arguments in their order.
struct Wording {
    MessageId id = MessageId::none;
    const char* name = "";      ///< for programs: "not_homed"
    const char* sentence = "";  ///< what is, or is wrong
    const char* remedy = "";    ///< what to do about it; stands behind the sentence; may be empty
    ArgumentName arguments[kMessageArguments]{};
    int mm_digits = 3;  ///< of lengths, behind the point

    std::size_t argument_count() const noexcept;
};

/// By their numbers.
std::vector<Wording> wordings();
/// Null: of another version.
const Wording* wording_of(MessageId id) noexcept;
/// "not_homed"; "unknown" for another version's.
std::string_view name_of(MessageId id) noexcept;

/// The message is known, with the arguments of its row, and each is something.
bool is_sound(const Message& message) noexcept;
/// Of a sound message, each by itself: "r1", "60.000 mm".
std::vector<std::string> argument_words(const Message& message);
/// The sentence and its remedy. Empty: there is no message. What is not sound gets words that say so: the
/// message may be of another process, and anything.
std::string in_words(const Message& message);

/// Several, with semicolons.
std::string in_words(const std::vector<Message>& messages);

/// The message as an error, with its words.
Error error_from(ErrorCode code, const Message& message);

}  // namespace psicarve
