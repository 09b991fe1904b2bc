// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace psicarve::report {

/// Seconds since 1970 as text for people: "2026-11-26 19:23 UTC".
std::string utc_text(std::int64_t seconds);
/// "2026-11-26T19:23:05Z".
std::string utc_stamp(std::int64_t seconds);

}  // namespace psicarve::report
