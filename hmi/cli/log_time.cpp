// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/log_time.hpp"

#include <array>
#include <charconv>
#include <ctime>
#include <optional>
#include <string_view>
#include <system_error>

namespace psicarve::cli {
namespace {

constexpr std::int64_t kMsPerSecond = 1000;
constexpr std::int64_t kMostBack_s = std::int64_t{100} * 366 * 24 * 3600;

std::optional<std::int64_t> seconds_of_unit(std::string_view unit) noexcept {
    if (unit == "s") return 1;
    if (unit == "m" || unit == "min") return 60;
    if (unit == "h") return 3600;
    if (unit == "d") return 24 * 3600;
    if (unit == "w") return 7 * 24 * 3600;
    return std::nullopt;
}

std::optional<std::int64_t> duration_s(std::string_view text) noexcept {
    std::int64_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc{} || count < 0) return std::nullopt;
    const auto unit = seconds_of_unit(text.substr(static_cast<std::size_t>(end - text.data())));
    if (!unit || count > kMostBack_s / *unit) return std::nullopt;
    return count * *unit;
}

/// Whether the whole text has this form; strptime alone accepts the 31st of February.
bool is_of_form(const std::string& text, const char* format, std::tm& fields) {
    const char* const end = strptime(text.c_str(), format, &fields);
    return end != nullptr && *end == '\0';
}

bool is_same_day(const std::tm& one, const std::tm& other) noexcept {
    return one.tm_year == other.tm_year && one.tm_mon == other.tm_mon && one.tm_mday == other.tm_mday;
}

std::optional<std::int64_t> seconds_of(const std::tm& fields, bool is_utc) {
    std::tm moment = fields;
    moment.tm_isdst = -1;
    const std::time_t seconds = is_utc ? timegm(&moment) : std::mktime(&moment);
    if (!is_same_day(moment, fields)) return std::nullopt;
    return std::int64_t{seconds};
}

/// The last moment with this time of day: one later than now is yesterday's.
std::optional<std::int64_t> last_moment_s(std::tm fields, bool is_utc, std::int64_t now_s) {
    const auto today = seconds_of(fields, is_utc);
    if (!today || *today <= now_s) return today;
    // At noon: the same time of day, also where the clock was changed in between.
    std::tm noon = fields;
    noon.tm_mday -= 1;
    noon.tm_hour = 12;
    noon.tm_isdst = -1;
    if (is_utc) {
        static_cast<void>(timegm(&noon));
    } else {
        static_cast<void>(std::mktime(&noon));
    }
    fields.tm_year = noon.tm_year;
    fields.tm_mon = noon.tm_mon;
    fields.tm_mday = noon.tm_mday;
    return seconds_of(fields, is_utc);
}

std::optional<std::int64_t> moment_s(std::string text, std::int64_t now_s) {
    const bool is_utc = text.ends_with('Z');
    if (is_utc) text.pop_back();
    for (const char* format :
         {"%Y-%m-%d", "%Y-%m-%d %H:%M", "%Y-%m-%d %H:%M:%S", "%Y-%m-%dT%H:%M", "%Y-%m-%dT%H:%M:%S"}) {
        std::tm fields{};
        if (is_of_form(text, format, fields)) return seconds_of(fields, is_utc);
    }
    for (const char* format : {"%H:%M", "%H:%M:%S"}) {
        const auto now = static_cast<std::time_t>(now_s);
        std::tm fields{};
        if ((is_utc ? gmtime_r(&now, &fields) : localtime_r(&now, &fields)) == nullptr) return std::nullopt;
        fields.tm_sec = 0;
        if (is_of_form(text, format, fields)) return last_moment_s(fields, is_utc, now_s);
    }
    return std::nullopt;
}

}  // namespace

Result<std::int64_t> since_ms(const std::string& text, std::int64_t now_ms) {
    if (const auto back = duration_s(text)) return now_ms - *back * kMsPerSecond;
    if (const auto moment = moment_s(text, now_ms / kMsPerSecond)) return *moment * kMsPerSecond;
    return Error{ErrorCode::bad_usage, "--since '" + text +
                                           "': neither a time back (90s, 30m, 2h, 3d, 1w) nor a moment "
                                           "(2026-11-26, '2026-11-26 19:23', 19:23)"};
}

std::string local_time_text(std::int64_t time_ms) {
    // Downwards, before 1970 as well.
    const std::int64_t seconds = time_ms / kMsPerSecond - (time_ms % kMsPerSecond < 0 ? 1 : 0);
    const auto instant = static_cast<std::time_t>(seconds);
    std::tm local{};
    std::array<char, 64> text{};
    if (localtime_r(&instant, &local) == nullptr) return "at an unknown time";
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S %z", &local);
    return {text.data(), length};
}

}  // namespace psicarve::cli
