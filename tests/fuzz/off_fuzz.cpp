// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>

#include "hmi/model/text_mesh_readers.hpp"
#include "tests/fuzz/mesh_fuzz.hpp"

/// Object File Format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    psicarve::fuzz::require_mesh_or_refusal({data, size}, &psicarve::model::read_off);
    return 0;
}
