// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>
#include <string>

#include "hmi/flat/grey_image.hpp"
#include "tests/fuzz/require.hpp"

/// A picture is refused with one line, or it has as many pixels as it says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace psicarve;
    using fuzz::require;
    const flat::Bytes bytes{data, size};
    // The other formats are read by their own libraries.
    for (const auto read : {&flat::read_bmp, &flat::read_pnm}) {
        const auto image = read(bytes, "fuzzed");
        if (!image) {
            require(!image.error().message.empty(), "an error says something");
            require(image.error().message.find('\n') == std::string::npos, "an error is one line");
            continue;
        }
        require(image->values.size() == image->width * image->height, "all pixels are there");
    }
    return 0;
}
