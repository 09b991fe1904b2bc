// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/utc_text.hpp"

#include <array>
#include <ctime>

namespace psicarve::report {
namespace {

/// Empty for a year that no calendar text can show.
std::string utc_as(std::int64_t seconds, const char* format) {
    const auto instant = static_cast<std::time_t>(seconds);
    std::tm utc{};
    std::array<char, 64> text{};
    if (gmtime_r(&instant, &utc) == nullptr) return "at an unknown time";
    const std::size_t length = std::strftime(text.data(), text.size(), format, &utc);
    return {text.data(), length};
}

}  // namespace

std::string utc_text(std::int64_t seconds) {
    return utc_as(seconds, "%Y-%m-%d %H:%M UTC");
}

std::string utc_stamp(std::int64_t seconds) {
    return utc_as(seconds, "%Y-%m-%dT%H:%M:%SZ");
}

}  // namespace psicarve::report
