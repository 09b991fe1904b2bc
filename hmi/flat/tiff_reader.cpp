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

#include "hmi/flat/exif.hpp"
#include "hmi/flat/grey_image.hpp"
#include "hmi/flat/tiff_pixels.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

// libtiff's messages go to functions of the whole process; the reading thread keeps its first here.
thread_local std::string* first_fault = nullptr;

void on_error(const char* /*module*/, const char* format, va_list arguments) {
    if (first_fault == nullptr || !first_fault->empty()) return;
    std::array<char, 160> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    *first_fault = text.data();
    for (char& c : *first_fault) c = c < ' ' || c > '~' ? '?' : c;
}

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

/// Says that the file is cut short; else which part of it is wrong.
Error damaged(const TiffBytes& source, const std::string& fault, const std::string& part,
              const std::string& file) {
    const bool is_cut = source.has_run_out || fault.find("ead error") != std::string::npos;
    return bad_input(file + ": a damaged TIFF picture: " + (is_cut ? "the file ends too early" : part));
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
    const std::unique_ptr<TIFF, TiffClose> tiff(
        TIFFClientOpen("picture", "rm", &source, TiffBytes::read, TiffBytes::write, TiffBytes::seek,
                       TiffBytes::close, TiffBytes::size, nullptr, nullptr));
    // Where samples differ, libtiff gives up before we can ask; its words are for programmers.
    if (!tiff && fault.find("different values per") != std::string::npos)
        return bad_input(file + ": a TIFF picture whose samples are of different sizes; save it as PNG");
    if (!tiff) return damaged(source, fault, "its directory cannot be read", file);
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    if (auto fits = check_image_size(width, height, file); !fits) return fits.error();
    const TiffShape shape = tiff_shape(tiff.get());
    if (auto known = check_tiff_kind(tiff.get(), shape, file); !known) return known.error();
    // A wrong entry of the directory that was skipped is no fault of the pixels.
    fault.clear();
    const bool has_16_bits = shape.bits == 16 && shape.is_as_it_stands();
    GreyImage image{width, height, {}, has_16_bits ? "TIFF, 16 bits" : "TIFF, 8 bits", {}};
    image.values.resize(image.width * image.height);
    if (!read_tiff_pixels(tiff.get(), shape, image) || !fault.empty())
        return damaged(source, fault, "its pixels cannot be unpacked", file);
    turn_upright(image, tiff_orientation(tiff.get()));
    if (!shape.is_grey()) image.warnings.emplace_back("the picture is in colour; its brightness is taken");
    if (shape.guesses_alpha)
        image.warnings.emplace_back("the picture does not say what its fourth sample is: taken as alpha");
    if (shape.bits == 16 && !has_16_bits)
        image.warnings.emplace_back("of the picture's 16 bits 8 are taken, as its samples lie in planes");
    return image;
}

}  // namespace psicarve::flat
