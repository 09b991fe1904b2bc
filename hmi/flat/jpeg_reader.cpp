// SPDX-License-Identifier: GPL-3.0-or-later
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>
// After <cstdio>: its header uses FILE and size_t without including them.
#include <jpeglib.h>

#include "hmi/flat/exif.hpp"
#include "hmi/flat/grey_image.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

/// One JPEG being read. libjpeg's errors leave by longjmp; we count its warnings (a file cut short is one) as
/// errors.
struct JpegJob {
    jpeg_error_mgr errors{};  // first: libjpeg hands us a pointer to it
    std::jmp_buf jump{};
    char fault[JMSG_LENGTH_MAX] = {};
    jpeg_decompress_struct state{};

    JpegJob() = default;
    JpegJob(const JpegJob&) = delete;
    JpegJob& operator=(const JpegJob&) = delete;
    ~JpegJob() { jpeg_destroy_decompress(&state); }
};

[[noreturn]] void on_error(j_common_ptr state) {
    auto* job = reinterpret_cast<JpegJob*>(state->err);
    state->err->format_message(state, job->fault);
    std::longjmp(job->jump, 1);
}
void on_message(j_common_ptr state, int level) {
    if (level < 0) on_error(state);
}

constexpr int kExifMarker = JPEG_APP0 + 1;
constexpr unsigned kLongestMarker = 0xFFFF;

/// Inks on white paper. Programs that write a marker of Adobe's store the visible paper, not the ink.
std::uint16_t grey_of_inks(const unsigned char* inks, bool is_paper) noexcept {
    std::uint32_t paper[4];
    for (int i = 0; i < 4; ++i) paper[i] = is_paper ? inks[i] : 255U - inks[i];
    const auto seen = [&paper](int i) { return (paper[i] * paper[3] * 257U + 127U) / 255U; };
    return grey_of(seen(0), seen(1), seen(2));
}

// The functions below hold a jump buffer: nothing with a destructor is made in them.
bool read_head(JpegJob& job, Bytes bytes) {
    if (setjmp(job.jump) != 0) return false;
    jpeg_create_decompress(&job.state);
    job.state.mem->max_memory_to_use = 1L << 29;
    jpeg_mem_src(&job.state, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_save_markers(&job.state, kExifMarker, kLongestMarker);
    jpeg_read_header(&job.state, TRUE);
    return true;
}

bool read_rows(JpegJob& job, unsigned char* row, std::uint16_t* const out) {
    if (setjmp(job.jump) != 0) return false;
    // Of a colour picture the library gives its Y, which is the brightness; inks it cannot turn to grey.
    const bool has_inks = job.state.jpeg_color_space == JCS_CMYK || job.state.jpeg_color_space == JCS_YCCK;
    job.state.out_color_space = has_inks ? JCS_CMYK : JCS_GRAYSCALE;
    jpeg_start_decompress(&job.state);
    while (job.state.output_scanline < job.state.output_height) {
        std::uint16_t* const line = out + std::size_t{job.state.output_scanline} * job.state.output_width;
        jpeg_read_scanlines(&job.state, &row, 1);
        for (JDIMENSION x = 0; x < job.state.output_width; ++x)
            line[x] = has_inks ? grey_of_inks(row + 4 * std::size_t{x}, job.state.saw_Adobe_marker != 0)
                               : static_cast<std::uint16_t>(row[x] * 257);
    }
    jpeg_finish_decompress(&job.state);
    return true;
}

/// The markers are freed when the rows are read.
int orientation_of(const jpeg_decompress_struct& state) {
    for (const auto* marker = state.marker_list; marker != nullptr; marker = marker->next) {
        const int orientation = exif_orientation({marker->data, marker->data_length});
        if (orientation != 1) return orientation;
    }
    return 1;
}

}  // namespace

Result<GreyImage> read_jpeg(Bytes bytes, const std::string& file) {
    JpegJob job;
    job.state.err = jpeg_std_error(&job.errors);
    job.errors.error_exit = on_error;
    job.errors.emit_message = on_message;
    if (!read_head(job, bytes)) return bad_input(file + ": a damaged JPEG picture: " + job.fault);
    if (auto fits = check_image_size(job.state.image_width, job.state.image_height, file); !fits)
        return fits.error();
    GreyImage image{job.state.image_width, job.state.image_height, {}, "JPEG", {}};
    const int orientation = orientation_of(job.state);
    const bool was_colour = job.state.num_components > 1;
    image.values.resize(image.width * image.height);
    std::vector<unsigned char> row(image.width * 4);
    if (!read_rows(job, row.data(), image.values.data())) {
        return bad_input(file + ": a damaged JPEG picture: " + job.fault);
    }
    turn_upright(image, orientation);
    if (was_colour) image.warnings.emplace_back("the picture is in colour; its brightness is taken");
    return image;
}

}  // namespace psicarve::flat
