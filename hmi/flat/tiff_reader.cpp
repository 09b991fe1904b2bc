// SPDX-License-Identifier: GPL-3.0-or-later
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "hmi/flat/exif.hpp"
#include "hmi/flat/grey_image.hpp"
#include "shared/result.hpp"

namespace psicarve::flat {
namespace {

// libtiff's messages go to functions of the whole process; the one that reads keeps its first here.
thread_local std::string* first_fault = nullptr;

void on_error(const char* /*module*/, const char* format, va_list arguments) {
    if (first_fault == nullptr || !first_fault->empty()) return;
    std::array<char, 160> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    *first_fault = text.data();
    for (char& c : *first_fault) c = c < ' ' || c > '~' ? '?' : c;
}

constexpr std::uint64_t kMostTileBytes = std::uint64_t{1} << 28U;

/// A TIFF in memory, as libtiff's calls see it.
struct TiffBytes {
    Bytes bytes;
    std::uint64_t at = 0;
    bool has_run_out = false;

    static tmsize_t read(thandle_t handle, void* target, tmsize_t length) {
        auto* self = static_cast<TiffBytes*>(handle);
        if (length < 0) return 0;
        const std::uint64_t there =
            self->bytes.size() - std::min<std::uint64_t>(self->at, self->bytes.size());
        const auto count = std::min(static_cast<std::uint64_t>(length), there);
        if (count < static_cast<std::uint64_t>(length)) self->has_run_out = true;
        if (count == 0) return 0;
        std::memcpy(target, self->bytes.data() + self->at, count);
        self->at += count;
        return static_cast<tmsize_t>(count);
    }
    static tmsize_t write(thandle_t /*handle*/, void* /*from*/, tmsize_t /*length*/) { return 0; }
    static toff_t seek(thandle_t handle, toff_t offset, int whence) {
        auto* self = static_cast<TiffBytes*>(handle);
        if (whence == SEEK_SET) self->at = offset;
        if (whence == SEEK_CUR) self->at += offset;
        if (whence == SEEK_END) self->at = self->bytes.size() + offset;
        return self->at;
    }
    static int close(thandle_t /*handle*/) { return 0; }
    static toff_t size(thandle_t handle) { return static_cast<TiffBytes*>(handle)->bytes.size(); }
};

struct TiffClose {
    void operator()(TIFF* tiff) const noexcept { TIFFClose(tiff); }
};

std::uint16_t field(TIFF* tiff, std::uint32_t tag, std::uint16_t otherwise) {
    std::uint16_t value = otherwise;
    TIFFGetFieldDefaulted(tiff, tag, &value);
    return value;
}

/// Grey of 8 or 16 bits; libtiff has turned the bytes of 16 to ours.
std::uint16_t grey_at(const unsigned char* row, std::size_t x, std::uint16_t bits) noexcept {
    if (bits == 8) return static_cast<std::uint16_t>(row[x] * 257);
    std::uint16_t value = 0;
    std::memcpy(&value, row + 2 * x, 2);
    return value;
}

/// Such grey in rows: as it stands.
bool read_grey_rows(TIFF* tiff, GreyImage& image, std::uint16_t bits) {
    const auto row_bytes = static_cast<std::size_t>(TIFFScanlineSize(tiff));
    if (row_bytes < image.width * bits / 8) return false;
    std::vector<unsigned char> row(row_bytes);
    for (std::size_t y = 0; y < image.height; ++y) {
        if (TIFFReadScanline(tiff, row.data(), static_cast<std::uint32_t>(y), 0) < 0) return false;
        for (std::size_t x = 0; x < image.width; ++x)
            image.values[y * image.width + x] = grey_at(row.data(), x, bits);
    }
    return true;
}

/// And in tiles, the last of which stand out over the picture's edges.
bool read_grey_tiles(TIFF* tiff, GreyImage& image, std::uint16_t bits) {
    std::uint32_t tile_width = 0;
    std::uint32_t tile_height = 0;
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &tile_width);
    TIFFGetField(tiff, TIFFTAG_TILELENGTH, &tile_height);
    const auto tile_bytes = static_cast<std::uint64_t>(TIFFTileSize(tiff));
    const auto row_bytes = static_cast<std::uint64_t>(TIFFTileRowSize(tiff));
    if (tile_width == 0 || tile_height == 0 || tile_bytes > kMostTileBytes ||
        row_bytes < std::uint64_t{tile_width} * bits / 8 || tile_bytes < row_bytes * tile_height) {
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
                    image.values[y * image.width + x] = grey_at(row, x - left, bits);
            }
        }
    }
    return true;
}

/// Everything else goes through libtiff's own way to colours; as it is stored, like the others.
bool read_as_colours(TIFF* tiff, GreyImage& image, std::uint16_t /*bits*/) {
    std::vector<std::uint32_t> pixels(image.width * image.height);
    if (TIFFReadRGBAImageOriented(tiff, static_cast<std::uint32_t>(image.width),
                                  static_cast<std::uint32_t>(image.height), pixels.data(),
                                  field(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT), 1) == 0) {
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

Result<GreyImage> read_tiff(Bytes bytes, const std::string& file) {
    static const bool handlers_set = [] {
        TIFFSetErrorHandler(on_error);
        TIFFSetWarningHandler(nullptr);
        return true;
    }();
    static_cast<void>(handlers_set);
    std::string fault;
    first_fault = &fault;
    struct Forget {
        ~Forget() { first_fault = nullptr; }
    } forget;
    TiffBytes source{bytes};
    const auto damaged = [&] {
        // libtiff names the row, counted in its own way, and bytes; or the part of the directory.
        if (source.has_run_out || fault.find("ead error") != std::string::npos)
            fault = "the file ends too early";
        return bad_input(file + ": a damaged TIFF picture" + (fault.empty() ? "" : ": " + fault));
    };
    const std::unique_ptr<TIFF, TiffClose> tiff(
        TIFFClientOpen("picture", "rm", &source, TiffBytes::read, TiffBytes::write, TiffBytes::seek,
                       TiffBytes::close, TiffBytes::size, nullptr, nullptr));
    if (!tiff) return damaged();
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    if (auto fits = check_image_size(width, height, file); !fits) return fits.error();
    const std::uint16_t bits = field(tiff.get(), TIFFTAG_BITSPERSAMPLE, 1);
    const std::uint16_t samples = field(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
    const std::uint16_t kind = field(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    const std::uint16_t number = field(tiff.get(), TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    if (number != SAMPLEFORMAT_UINT && number != SAMPLEFORMAT_VOID) {
        return bad_input(file + ": a TIFF picture of signed or floating numbers; save it with 8 or 16 bits");
    }
    const bool is_grey = kind == PHOTOMETRIC_MINISBLACK || kind == PHOTOMETRIC_MINISWHITE;
    const bool as_it_stands = is_grey && samples == 1 && (bits == 8 || bits == 16);
    GreyImage image{width, height, {}, as_it_stands && bits == 16 ? "TIFF, 16 bits" : "TIFF, 8 bits", {}};
    image.values.resize(image.width * image.height);
    const auto read = !as_it_stands ? &read_as_colours
                                    : (TIFFIsTiled(tiff.get()) != 0 ? &read_grey_tiles : &read_grey_rows);
    if (!read(tiff.get(), image, bits) || !fault.empty()) return damaged();
    if (as_it_stands && kind == PHOTOMETRIC_MINISWHITE) {
        for (std::uint16_t& value : image.values) value = static_cast<std::uint16_t>(65535 - value);
    }
    turn_upright(image, field(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT));
    if (!is_grey) image.warnings.emplace_back("the picture is in colour; its brightness is taken");
    if (is_grey && bits == 16 && !as_it_stands)
        image.warnings.emplace_back("of the picture's 16 bits 8 are taken, as it holds more than grey");
    return image;
}

}  // namespace psicarve::flat
