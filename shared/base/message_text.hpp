// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/base/shared_text.hpp"
#include "shared/message/message.hpp"

namespace psicarve {

/// The message with one more argument, its text: as far as it fits, whole letters.
inline Message with_text(Message message, const std::string& text) {
    if (message.argument_count < kMessageArguments)
        message.arguments[message.argument_count++] = argument(ArgumentKind::text, 0);
    text_into_field(message.text, text);
    return message;
}

/// Whatever another process wrote: it ends at its first zero or at the field's end, control characters are
/// '?'.
inline std::string text_of(const Message& message) {
    return text_from_field(message.text);
}

}  // namespace psicarve
