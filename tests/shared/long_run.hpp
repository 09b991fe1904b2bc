// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string_view>

namespace psicarve::test {

/// Whether tests with a long form are to take it: `scripts/test.sh --long` sets PSICARVE_LONG=1.
inline bool is_long_run() {
    const char* const is_long = std::getenv("PSICARVE_LONG");
    return is_long != nullptr && std::string_view{is_long} == "1";
}

}  // namespace psicarve::test
