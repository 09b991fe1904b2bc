// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/tiff_pixels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "hmi/flat/grey_image.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

constexpr std::uint64_t kMostTileBytes = std::uint64_t{1} << 28U;
constexpr std::uint16_t kMostSamplesOfPixel = 8;

std::uint16_t tiff_field(TIFF* tiff, std::uint32_t tag, std::uint16_t otherwise) {
    std::uint16_t value = otherwise;
    TIFFGetFieldDefaulted(tiff, tag, &value);
    return value;
}

/// The use of the first sample that is no colour. Four samples whose last is not named are read as most
/// programs do.
TiffAlpha tiff_alpha(TIFF* tiff, TiffShape& shape) {
    if (shape.samples <= shape.colours()) return TiffAlpha::none;  // whatever the tag says
    std::uint16_t count = 0;
    std::uint16_t* kinds = nullptr;
    if (TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &count, &kinds) == 0 || count == 0)
        return TiffAlpha::none;
    if (kinds[0] == EXTRASAMPLE_ASSOCALPHA) return TiffAlpha::associated;
    if (kinds[0] == EXTRASAMPLE_UNASSALPHA) return TiffAlpha::unassociated;
    shape.guesses_alpha = shape.kind == PHOTOMETRIC_RGB && shape.samples == 4;
    return shape.guesses_alpha ? TiffAlpha::associated : TiffAlpha::none;
}

/// libtiff has turned the bytes of 16 bits to ours.
std::uint32_t sample_at(const unsigned char* row, std::size_t index, std::uint16_t bits) noexcept {
    if (bits == 8) return row[index] * 257U;
    std::uint16_t value = 0;
    std::memcpy(&value, row + 2 * index, 2);
    return value;
}

std::uint16_t tiff_grey_at(const unsigned char* row, std::size_t x, const TiffShape& shape) noexcept {
    const auto sample = [&](std::size_t k) { return sample_at(row, x * shape.samples + k, shape.bits); };
    const std::uint32_t stored = shape.is_grey() ? sample(0) : grey_of(sample(0), sample(1), sample(2));
    const bool is_ink = shape.kind == PHOTOMETRIC_MINISWHITE;
    const std::uint32_t grey = is_ink ? 65535U - stored : stored;
    switch (shape.alpha) {
        case TiffAlpha::none:
            break;
        case TiffAlpha::unassociated:
            return over_white(grey, sample(shape.colours()));
        case TiffAlpha::associated:
            // The stored values are multiplied by alpha already; less ink lets more of the paper through.
            if (!is_ink)
                return static_cast<std::uint16_t>(std::min(65535U, grey + 65535U - sample(shape.colours())));
            break;
    }
    return static_cast<std::uint16_t>(grey);
}

std::uint64_t pixel_bytes(const TiffShape& shape) noexcept {
    return std::uint64_t{shape.samples} * shape.bits / 8;
}

bool read_sample_rows(TIFF* tiff, const TiffShape& shape, GreyImage& image) {
    const auto row_bytes = static_cast<std::uint64_t>(TIFFScanlineSize(tiff));
    if (row_bytes < image.width * pixel_bytes(shape) || row_bytes > kMostTileBytes) return false;
    std::vector<unsigned char> row(row_bytes);
    for (std::size_t y = 0; y < image.height; ++y) {
        if (TIFFReadScanline(tiff, row.data(), static_cast<std::uint32_t>(y), 0) < 0) return false;
        for (std::size_t x = 0; x < image.width; ++x)
            image.values[y * image.width + x] = tiff_grey_at(row.data(), x, shape);
    }
    return true;
}

/// The last tiles stand out over the picture's edges.
bool read_sample_tiles(TIFF* tiff, const TiffShape& shape, GreyImage& image) {
    std::uint32_t tile_width = 0;
    std::uint32_t tile_height = 0;
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &tile_width);
    TIFFGetField(tiff, TIFFTAG_TILELENGTH, &tile_height);
    const auto tile_bytes = static_cast<std::uint64_t>(TIFFTileSize(tiff));
    const auto row_bytes = static_cast<std::uint64_t>(TIFFTileRowSize(tiff));
    if (tile_width == 0 || tile_height == 0 || tile_bytes > kMostTileBytes ||
        row_bytes < tile_width * pixel_bytes(shape) || tile_bytes < row_bytes * tile_height) {
        return false;
    }
    std::vector<unsigned char> tile(tile_bytes);
    for (std::size_t top = 0; top < image.height; top += tile_height) {
        for (std::size_t left = 0; left < image.width; left += tile_width) {
            if (TIFFReadTile(tiff, tile.data(), static_cast<std::uint32_t>(left),
                             static_cast<std::uint32_t>(top), 0, 0) < 0) {
                return false;
            }
            const std::size_t bottom = std::min<std::size_t>(image.height, top + tile_height);
            const std::size_t right = std::min<std::size_t>(image.width, left + tile_width);
            for (std::size_t y = top; y < bottom; ++y) {
                const unsigned char* const row = tile.data() + (y - top) * row_bytes;
                for (std::size_t x = left; x < right; ++x)
                    image.values[y * image.width + x] = tiff_grey_at(row, x - left, shape);
            }
        }
    }
    return true;
}

/// Uses libtiff's own conversion to colours; as stored, like the others.
bool read_as_colours(TIFF* tiff, GreyImage& image) {
    std::vector<std::uint32_t> pixels(image.width * image.height);
    if (TIFFReadRGBAImageOriented(tiff, static_cast<std::uint32_t>(image.width),
                                  static_cast<std::uint32_t>(image.height), pixels.data(),
                                  tiff_orientation(tiff), 1) == 0) {
        return false;
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::uint32_t p = pixels[i];  // colours are multiplied by alpha already
        const std::uint32_t grey = grey_of(TIFFGetR(p) * 257U, TIFFGetG(p) * 257U, TIFFGetB(p) * 257U);
        image.values[i] = static_cast<std::uint16_t>(std::min(65535U, grey + 65535U - TIFFGetA(p) * 257U));
    }
    return true;
}

}  // namespace

bool TiffShape::is_as_it_stands() const noexcept {
    return (is_grey() || kind == PHOTOMETRIC_RGB) && (bits == 8 || bits == 16) && is_together &&
           samples >= colours() && samples <= kMostSamplesOfPixel;
}

TiffShape tiff_shape(TIFF* tiff) {
    TiffShape shape;
    shape.bits = tiff_field(tiff, TIFFTAG_BITSPERSAMPLE, 1);
    shape.samples = tiff_field(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    // Without the tag the picture has red, green and blue if it has enough samples.
    shape.kind =
        tiff_field(tiff, TIFFTAG_PHOTOMETRIC, shape.samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
    shape.number = tiff_field(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    shape.is_together = shape.samples == 1 ||
                        tiff_field(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_CONTIG;
    shape.alpha = tiff_alpha(tiff, shape);
    return shape;
}

Result<void> check_tiff_kind(TIFF* tiff, const TiffShape& shape, const std::string& file) {
    if (shape.number != SAMPLEFORMAT_UINT && shape.number != SAMPLEFORMAT_VOID)
        return bad_input(file + ": a TIFF picture of signed or floating numbers; save it with 8 or 16 bits");
    const std::uint16_t packing = tiff_field(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    if (TIFFIsCODECConfigured(packing) == 0) {
        return bad_input(file + ": a TIFF picture that is packed in a way that is not read (compression " +
                         std::to_string(packing) + "); save it as PNG");
    }
    const bool is_fine = shape.is_grey() || shape.kind == PHOTOMETRIC_PALETTE;
    const bool has_depth = shape.bits == 8 || shape.bits == 16 ||
                           (is_fine && (shape.bits == 1 || shape.bits == 2 || shape.bits == 4));
    if (!has_depth) {
        return bad_input(file + ": a TIFF picture of " + std::to_string(shape.bits) +
                         " bits a sample: 8 or 16 are read");
    }
    if (shape.is_as_it_stands()) return {};
    std::array<char, 1024> why{};  // as long as libtiff's longest
    TIFFRGBAImage all{};
    const bool can_be_read =
        TIFFRGBAImageOK(tiff, why.data()) != 0 && TIFFRGBAImageBegin(&all, tiff, 1, why.data()) != 0;
    if (can_be_read) {
        TIFFRGBAImageEnd(&all);
        return {};
    }
    return bad_input(file + ": a TIFF picture of a kind that is not read (" + std::to_string(shape.samples) +
                     " samples of " + std::to_string(shape.bits) + " bits, photometric " +
                     std::to_string(shape.kind) + "); save it as PNG");
}

bool read_tiff_pixels(TIFF* tiff, const TiffShape& shape, GreyImage& image) {
    if (!shape.is_as_it_stands()) return read_as_colours(tiff, image);
    return TIFFIsTiled(tiff) != 0 ? read_sample_tiles(tiff, shape, image)
                                  : read_sample_rows(tiff, shape, image);
}

std::uint16_t tiff_orientation(TIFF* tiff) {
    return tiff_field(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
}

}  // namespace psicarve::flat
