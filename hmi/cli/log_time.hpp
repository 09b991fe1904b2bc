// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Reads the value of --since: a time before now ("90s", "30m", "2h", "3d", "1w"), a day ("2026-11-26"), a
/// moment ("2026-11-26 19:23", "2026-11-26T19:23:05", with Z: UTC), a time of day ("19:23"), of today or,
/// where that is still to come, of yesterday. Local time otherwise. Milliseconds since 1970; bad_usage for
/// any other text.
Result<std::int64_t> since_ms(const std::string& text, std::int64_t now_ms);

/// "2026-11-26 19:23:05 +0100". Empty for a year that no calendar text can show.
std::string local_time_text(std::int64_t time_ms);

}  // namespace psicarve::cli
