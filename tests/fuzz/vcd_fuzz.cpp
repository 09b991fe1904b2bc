// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/trace_fuzz.hpp"

/// Value-change dumps, ours and other programs'.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    psicarve::fuzz::require_trace_or_refusal({data, size}, "fuzzed.vcd");
    return 0;
}
