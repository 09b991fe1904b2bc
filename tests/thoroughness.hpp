// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string_view>

namespace psicarve::test {

#if defined(__has_feature)
inline constexpr bool kIsAddressSanitized = __has_feature(address_sanitizer);
inline constexpr bool kIsThreadSanitized = __has_feature(thread_sanitizer);
#else
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kIsAddressSanitized = true;
#else
inline constexpr bool kIsAddressSanitized = false;
#endif
#if defined(__SANITIZE_THREAD__)
inline constexpr bool kIsThreadSanitized = true;
#else
inline constexpr bool kIsThreadSanitized = false;
#endif
#endif
inline constexpr bool kIsSanitized = kIsAddressSanitized || kIsThreadSanitized;

/// Whether tests with a long form are to take it: `scripts/test.sh --long` sets PSICARVE_LONG=1.
inline bool is_long_run() {
    const char* const is_long = std::getenv("PSICARVE_LONG");
    return is_long != nullptr && std::string_view{is_long} == "1";
}

/// Whether sweeps take their whole form. Sanitizers look for other faults than sweeps do, and take ten times
/// as long.
inline bool is_thorough() {
    return !kIsSanitized || is_long_run();
}

}  // namespace psicarve::test
