// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>
// After <cstdio>, which it needs.
#include <jpeglib.h>

#include "hmi/flat/grey_image.hpp"
#include "tests/hmi/flat/flat_files.hpp"

namespace psicarve::flat {

inline std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The samples of one picture, 0 to 65535.
struct Samples {
    std::uint32_t width;
    std::uint32_t height;
    std::vector<std::uint16_t> values;
};

inline Samples ramp() {
    Samples samples{16, 2, {}};
    for (std::uint32_t i = 0; i < 32; ++i)
        samples.values.push_back(static_cast<std::uint16_t>((i % 16) * 4000 + i));
    return samples;
}

class PictureTest : public FlatTest {
protected:
    std::string jpeg(const std::string& name, const Samples& samples, const std::string& marker = "") const {
        const std::string path = file(name, "");
        std::FILE* out = std::fopen(path.c_str(), "wb");
        jpeg_compress_struct state{};
        jpeg_error_mgr errors{};
        state.err = jpeg_std_error(&errors);
        jpeg_create_compress(&state);
        jpeg_stdio_dest(&state, out);
        state.image_width = samples.width;
        state.image_height = samples.height;
        state.input_components = 1;
        state.in_color_space = JCS_GRAYSCALE;
        jpeg_set_defaults(&state);
        jpeg_set_quality(&state, 100, TRUE);
        jpeg_start_compress(&state, TRUE);
        if (!marker.empty()) {
            jpeg_write_marker(&state, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(marker.data()),
                              static_cast<unsigned>(marker.size()));
        }
        std::vector<std::uint8_t> small;
        for (const auto value : samples.values) small.push_back(static_cast<std::uint8_t>(value / 257));
        for (std::uint32_t y = 0; y < samples.height; ++y) {
            JSAMPROW row = &small[y * samples.width];
            jpeg_write_scanlines(&state, &row, 1);
        }
        jpeg_finish_compress(&state);
        jpeg_destroy_compress(&state);
        std::fclose(out);
        return path;
    }
    static GreyImage read(const std::string& path) {
        const std::string bytes = bytes_of(path);
        auto image = read_image({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, path);
        EXPECT_TRUE(image.has_value()) << (image ? "" : image.error().message);
        return image ? std::move(*image) : GreyImage{};
    }
};

}  // namespace psicarve::flat
