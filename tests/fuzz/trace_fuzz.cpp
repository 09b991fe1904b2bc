// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/trace_format.hpp"
#include "tests/fuzz/trace_fuzz.hpp"

/// Binary pin traces: all bytes are read as one, whatever they begin with.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::uint8_t> bytes(data, data + size);
    const auto magic = std::as_bytes(std::span(&psicarve::kTraceMagic, 1));
    for (std::size_t i = 0; i < std::min(bytes.size(), magic.size()); ++i)
        bytes[i] = std::to_integer<std::uint8_t>(magic[i]);
    psicarve::fuzz::require_trace_or_refusal(bytes, "fuzzed");
    return 0;
}
