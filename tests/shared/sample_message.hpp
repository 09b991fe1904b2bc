// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared/base/message_text.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::test {

/// A sound message of this row; 1 is something of every kind.
inline Message sample_message(const Wording& row) {
    Message message = message_of(row.id);
    for (std::size_t i = 0; i < row.argument_count(); ++i) {
        if (row.arguments[i].kind == ArgumentKind::text) {
            message = with_text(message, "/sample");
        } else {
            message.arguments[message.argument_count++] = argument(row.arguments[i].kind, 1);
        }
    }
    return message;
}

}  // namespace psicarve::test
