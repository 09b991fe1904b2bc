// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <png.h>
#include <tiffio.h>

#include <array>
#include <cstddef>
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
#include "hmi/flat/relief.hpp"
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

/// A TIFF of samples beside each other, or not.
struct TiffKind {
    std::uint16_t bits = 16;
    std::uint16_t samples = 1;
    std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
    std::vector<std::uint16_t> extra;  ///< EXTRASAMPLE_...
    std::uint16_t planes = PLANARCONFIG_CONTIG;
    std::uint32_t tile_side = 0;
    const char* mode = "wl";
};

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
    std::string pgm(const std::string& name, const Samples& samples) const {
        std::string text = "P2\n# by hand\n" + std::to_string(samples.width) + " " +
                           std::to_string(samples.height) + " 65535\n";
        for (const auto value : samples.values) text += std::to_string(value) + "\n";
        return file(name, text);
    }
    std::string png(const std::string& name, const Samples& samples, int bits) const {
        const std::string path = file(name, "");
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        image.width = samples.width;
        image.height = samples.height;
        image.format = bits == 16 ? PNG_FORMAT_LINEAR_Y : PNG_FORMAT_GRAY;
        std::vector<std::uint8_t> small;
        for (const auto value : samples.values) small.push_back(static_cast<std::uint8_t>(value / 257));
        const void* from = bits == 16 ? static_cast<const void*>(samples.values.data()) : small.data();
        EXPECT_NE(png_image_write_to_file(&image, path.c_str(), 0, from, 0, nullptr), 0);
        return path;
    }
    std::string tiff(const std::string& name, const Samples& samples, int bits) const {
        const std::string path = file(name, "");
        TIFF* out = TIFFOpen(path.c_str(), "wb");
        TIFFSetField(out, TIFFTAG_IMAGEWIDTH, samples.width);
        TIFFSetField(out, TIFFTAG_IMAGELENGTH, samples.height);
        TIFFSetField(out, TIFFTAG_BITSPERSAMPLE, bits);
        TIFFSetField(out, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(out, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(out, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
        for (std::uint32_t y = 0; y < samples.height; ++y) {
            std::vector<std::uint16_t> row(&samples.values[y * samples.width],
                                           &samples.values[y * samples.width] + samples.width);
            std::vector<std::uint8_t> small;
            for (const auto value : row) small.push_back(static_cast<std::uint8_t>(value / 257));
            void* from = bits == 16 ? static_cast<void*>(row.data()) : small.data();
            TIFFWriteScanline(out, from, y, 0);
        }
        TIFFClose(out);
        return path;
    }
    /// PNG of 1 to 4 samples a pixel, of 16 bits as they stand, or of 8.
    std::string png_of(const std::string& name, const Samples& pixels, int samples, int bits) const {
        const std::string path = file(name, "");
        std::FILE* out = std::fopen(path.c_str(), "wb");
        png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
        png_infop head = png_create_info_struct(png);
        png_init_io(png, out);
        const std::array kinds{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                               PNG_COLOR_TYPE_RGB_ALPHA};
        png_set_IHDR(png, head, pixels.width, pixels.height, bits,
                     kinds[static_cast<std::size_t>(samples - 1)], PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png, head);
        const std::size_t row_samples = pixels.width * static_cast<std::size_t>(samples);
        for (std::size_t y = 0; y < pixels.height; ++y) {
            std::vector<png_byte> row;
            for (std::size_t i = 0; i < row_samples; ++i) {
                const std::uint16_t value = pixels.values[y * row_samples + i];
                row.push_back(static_cast<png_byte>(value >> 8U));
                if (bits == 16) row.push_back(static_cast<png_byte>(value & 0xffU));
            }
            png_write_row(png, row.data());
        }
        png_write_end(png, nullptr);
        png_destroy_write_struct(&png, &head);
        std::fclose(out);
        return path;
    }
    std::string tiff_of(const std::string& name, const Samples& pixels, const TiffKind& kind) const {
        const std::string path = file(name, "");
        TIFF* out = TIFFOpen(path.c_str(), kind.mode);
        TIFFSetField(out, TIFFTAG_IMAGEWIDTH, pixels.width);
        TIFFSetField(out, TIFFTAG_IMAGELENGTH, pixels.height);
        TIFFSetField(out, TIFFTAG_BITSPERSAMPLE, kind.bits);
        TIFFSetField(out, TIFFTAG_SAMPLESPERPIXEL, kind.samples);
        TIFFSetField(out, TIFFTAG_PHOTOMETRIC, kind.photometric);
        TIFFSetField(out, TIFFTAG_PLANARCONFIG, kind.planes);
        TIFFSetField(out, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
        if (!kind.extra.empty()) {
            TIFFSetField(out, TIFFTAG_EXTRASAMPLES, static_cast<int>(kind.extra.size()), kind.extra.data());
        }
        const bool is_parted = kind.planes == PLANARCONFIG_SEPARATE;
        const std::uint32_t together = is_parted ? 1U : kind.samples;
        // What stands at (x, y), sample k, as bytes of this machine.
        const auto put = [&](std::string& bytes, std::uint32_t x, std::uint32_t y, std::uint32_t k) {
            const bool is_there = x < pixels.width && y < pixels.height;
            const std::uint32_t value =
                is_there ? pixels.values[(y * pixels.width + x) * kind.samples + k] : 0U;
            const std::uint64_t wide = kind.bits == 8 ? value >> 8U : value;
            bytes.append(reinterpret_cast<const char*>(&wide), kind.bits / 8U);
        };
        const std::uint32_t step_x = kind.tile_side == 0 ? pixels.width : kind.tile_side;
        const std::uint32_t step_y = kind.tile_side == 0 ? 1 : kind.tile_side;
        if (kind.tile_side != 0) {
            TIFFSetField(out, TIFFTAG_TILEWIDTH, kind.tile_side);
            TIFFSetField(out, TIFFTAG_TILELENGTH, kind.tile_side);
        } else {
            TIFFSetField(out, TIFFTAG_ROWSPERSTRIP, 1);
        }
        for (std::uint16_t plane = 0; plane < kind.samples / together; ++plane) {
            for (std::uint32_t top = 0; top < pixels.height; top += step_y) {
                for (std::uint32_t left = 0; left < pixels.width; left += step_x) {
                    std::string bytes;
                    for (std::uint32_t i = 0; i < step_x * step_y; ++i) {
                        for (std::uint32_t k = 0; k < together; ++k)
                            put(bytes, left + i % step_x, top + i / step_x, plane + k);
                    }
                    if (kind.tile_side == 0) {
                        TIFFWriteScanline(out, bytes.data(), top, plane);
                    } else {
                        TIFFWriteTile(out, bytes.data(), left, top, 0, plane);
                    }
                }
            }
        }
        TIFFClose(out);
        return path;
    }
    static GreyImage read(const std::string& path) {
        const std::string bytes = bytes_of(path);
        auto image = read_image({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, path);
        EXPECT_TRUE(image.has_value()) << (image ? "" : image.error().message);
        return image ? std::move(*image) : GreyImage{};
    }
    static DepthMap depths(const GreyImage& image, const FlatOptions& options) {
        auto map = depths_of(image, options, "f");
        EXPECT_TRUE(map.has_value()) << (map ? "" : map.error().message);
        return map ? std::move(*map) : DepthMap{};
    }
};

}  // namespace psicarve::flat
