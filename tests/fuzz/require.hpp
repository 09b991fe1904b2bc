// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve::fuzz {

/// Ends the program, which is what a fuzzer takes for a finding, unless it holds.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

/// What is refused is so in one line that says something.
template <typename T>
void require_one_line(const Result<T>& result) {
    if (result) return;
    require(!result.error().message.empty(), "an error says something");
    require(result.error().message.find('\n') == std::string::npos, "an error is one line");
}

}  // namespace psicarve::fuzz
