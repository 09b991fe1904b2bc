// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shared/message/message.hpp"

namespace psicarve {

// A message as it is written down, beside its name (name_of() in wording.hpp): to be said in another language
// by whoever reads it later.

/// The values of its arguments in hexadecimal, with blanks: "2 4050000000000000". Their kinds are those of
/// the table of words. Empty: it has none.
std::string arguments_text(const Message& message);

/// The message of this name with these arguments and this text. Nothing: the name is not known, or they are
/// not its. Trusts no byte.
std::optional<Message> message_from(std::string_view name, std::string_view arguments, std::string_view text);

}  // namespace psicarve
