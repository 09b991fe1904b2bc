// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shared/message/message.hpp"

namespace psicarve::report {

/// {"id": "outside_travel", "arguments": {"axis": "r1", "from_mm": 0.0, ...}}: numbers as such, words of the
/// machine by their names. Null: none, of another version, or damaged.
nlohmann::ordered_json message_json(const Message& message);

}  // namespace psicarve::report
