// SPDX-License-Identifier: GPL-3.0-or-later
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hmi/flat/grey_image.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

/// One PNG being read. libpng leaves by longjmp: what it jumps over has no destructor to run.
struct PngJob {
    Bytes bytes;
    std::size_t at = 0;
    char fault[128] = {};
    png_structp png = nullptr;
    png_infop info = nullptr;

    explicit PngJob(Bytes from) : bytes(from) {}
    PngJob(const PngJob&) = delete;
    PngJob& operator=(const PngJob&) = delete;
    ~PngJob() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void on_error(png_structp png, png_const_charp text) {
    auto* job = static_cast<PngJob*>(png_get_error_ptr(png));
    std::strncpy(job->fault, text, sizeof job->fault - 1);
    std::longjmp(png_jmpbuf(png), 1);
}
void on_warning(png_structp /*png*/, png_const_charp /*text*/) {}

void on_read(png_structp png, png_bytep target, std::size_t length) {
    auto* job = static_cast<PngJob*>(png_get_io_ptr(png));
    if (length > job->bytes.size() - job->at) png_error(png, "the file ends too early");
    std::memcpy(target, job->bytes.data() + job->at, length);
    job->at += length;
}

struct PngShape {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int depth = 0;
    int channels = 0;
    bool was_colour = false;
    std::size_t row_bytes = 0;
};

// The functions below hold a jump buffer: nothing with a destructor is made in them.
bool read_head(PngJob& job, PngShape& shape) {
    if (setjmp(png_jmpbuf(job.png)) != 0) return false;
    png_set_read_fn(job.png, &job, on_read);
    png_set_user_limits(job.png, kMostSide, kMostSide);
    png_read_info(job.png, job.info);
    shape.width = png_get_image_width(job.png, job.info);
    shape.height = png_get_image_height(job.png, job.info);
    const int colour = png_get_color_type(job.png, job.info);
    shape.was_colour = (colour & PNG_COLOR_MASK_COLOR) != 0;
    if (colour == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(job.png);
    if (colour == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(job.png);
    if (png_get_valid(job.png, job.info, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(job.png);
    png_set_interlace_handling(job.png);
    png_read_update_info(job.png, job.info);
    shape.depth = png_get_bit_depth(job.png, job.info);
    shape.channels = png_get_channels(job.png, job.info);
    shape.row_bytes = png_get_rowbytes(job.png, job.info);
    return true;
}

bool read_rows(PngJob& job, png_bytepp rows) {
    if (setjmp(png_jmpbuf(job.png)) != 0) return false;
    png_read_image(job.png, rows);
    png_read_end(job.png, nullptr);
    return true;
}

std::uint16_t grey_at(const unsigned char* pixel, const PngShape& shape) noexcept {
    const auto channel = [&](int k) -> std::uint32_t {
        if (shape.depth == 16) return (std::uint32_t{pixel[2 * k]} << 8U) | pixel[2 * k + 1];
        return pixel[k] * 257U;
    };
    const bool is_colour = shape.channels >= 3;
    const std::uint16_t grey =
        is_colour ? grey_of(channel(0), channel(1), channel(2)) : static_cast<std::uint16_t>(channel(0));
    const bool has_alpha = shape.channels == 2 || shape.channels == 4;
    return has_alpha ? over_white(grey, channel(shape.channels - 1)) : grey;
}

}  // namespace

Result<GreyImage> read_png(Bytes bytes, const std::string& file) {
    PngJob job(bytes);
    job.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, on_error, on_warning);
    if (job.png == nullptr)
        return Error{ErrorCode::out_of_room, file + ": too large for this computer's memory"};
    job.info = png_create_info_struct(job.png);
    if (job.info == nullptr)
        return Error{ErrorCode::out_of_room, file + ": too large for this computer's memory"};
    PngShape shape;
    if (!read_head(job, shape)) return bad_input(file + ": a damaged PNG picture: " + job.fault);
    if (auto fits = check_image_size(shape.width, shape.height, file); !fits) return fits.error();

    std::vector<unsigned char> pixels(shape.row_bytes * shape.height);
    std::vector<png_bytep> rows(shape.height);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels.data() + y * shape.row_bytes;
    if (!read_rows(job, rows.data())) return bad_input(file + ": a damaged PNG picture: " + job.fault);

    GreyImage image{shape.width, shape.height, {}, shape.depth == 16 ? "PNG, 16 bits" : "PNG, 8 bits", {}};
    image.values.reserve(image.width * image.height);
    const std::size_t pixel_bytes = static_cast<std::size_t>(shape.channels) * (shape.depth == 16 ? 2 : 1);
    for (const png_bytep row : rows) {
        for (std::size_t x = 0; x < image.width; ++x) {
            image.values.push_back(grey_at(row + x * pixel_bytes, shape));
        }
    }
    if (shape.was_colour) image.warnings.emplace_back("the picture is in colour; its brightness is taken");
    return image;
}

}  // namespace psicarve::flat
