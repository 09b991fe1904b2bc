// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>

#include "hmi/model/stl_reader.hpp"
#include "tests/fuzz/mesh_fuzz.hpp"

/// Both kinds of STL: all bytes are read as each of them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    psicarve::fuzz::require_mesh_or_refusal({data, size}, &psicarve::model::read_ascii_stl);
    psicarve::fuzz::require_mesh_or_refusal({data, size}, &psicarve::model::read_binary_stl);
    return 0;
}
