// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// Why a measurement cannot be; nothing when it is no such sentence.
std::optional<Phrase> calibration_phrase(const std::string& message);

}  // namespace psicarve::session
