// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/picture/canvas.hpp"

#include <cstring>

#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
    auto& out = *static_cast<std::vector<std::byte>*>(bytes);
    const auto* from = reinterpret_cast<const std::byte*>(data);
    out.insert(out.end(), from, from + length);
    return CAIRO_STATUS_SUCCESS;
}

/// Bytes of the UTF-8 sequence that begins at `text[at]`; 0 when there is none.
std::size_t sequence_bytes(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t n) {
        return n < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[n])) : 0U;
    };
    const unsigned lead = byte(at);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(at + k) & 0xC0) != 0x80) return 0;
    }
    // Overlong forms, surrogates and what lies past the last code point.
    const unsigned second = byte(at + 1);
    if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
        (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F))
        return 0;
    return lead < 0x20 || lead == 0x7F ? 0 : length;
}

}  // namespace

std::string as_utf8(const std::string& bytes) {
    std::string text;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t length = sequence_bytes(bytes, at);
        if (length == 0)
            text += '?';
        else
            text.append(bytes, at, length);
        at += length == 0 ? 1 : length;
    }
    return text;
}

Canvas::Canvas(int width_px, int height_px, const Rgb& background)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px)),
      context_(cairo_create(surface_.get())) {
    set(background);
    cairo_paint(context_.get());
}

void Canvas::set(const Font& font) {
    cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context_.get(), font.size_px);
    set(font.colour);
}

double Canvas::text_width(const std::string& utf8, const Font& font) {
    set(font);
    cairo_text_extents_t extents;
    cairo_text_extents(context_.get(), utf8.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::text(double x, double y, const std::string& utf8, const Font& font, Align align,
                  double most_px) {
    std::string shown = as_utf8(utf8);
    double width = text_width(shown, font);
    if (width > most_px) {
        std::string kept = shown;
        while (!kept.empty() && width > most_px) {
            do {
                kept.pop_back();
            } while (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0x80) != 0 &&
                     as_utf8(kept) != kept);
            shown = kept + "\u2026";
            width = text_width(shown, font);
        }
    }
    if (align != Align::left) x -= align == Align::centre ? width / 2.0 : width;
    cairo_move_to(context_.get(), x, y);
    cairo_show_text(context_.get(), shown.c_str());
}

void Canvas::line(double x0, double y0, double x1, double y1, const Rgb& colour, double width_px) {
    set(colour);
    cairo_set_line_width(context_.get(), width_px);
    cairo_move_to(context_.get(), x0, y0);
    cairo_line_to(context_.get(), x1, y1);
    cairo_stroke(context_.get());
}

void Canvas::outline(const Box& box, double corner_px) {
    cairo_t* c = context_.get();
    if (corner_px <= 0.0) {
        cairo_rectangle(c, box.x, box.y, box.width, box.height);
        return;
    }
    const double right = box.x + box.width - corner_px;
    const double bottom = box.y + box.height - corner_px;
    cairo_new_sub_path(c);
    cairo_arc(c, right, box.y + corner_px, corner_px, -kPi / 2.0, 0.0);
    cairo_arc(c, right, bottom, corner_px, 0.0, kPi / 2.0);
    cairo_arc(c, box.x + corner_px, bottom, corner_px, kPi / 2.0, kPi);
    cairo_arc(c, box.x + corner_px, box.y + corner_px, corner_px, kPi, 1.5 * kPi);
    cairo_close_path(c);
}

void Canvas::fill(const Box& box, const Rgb& colour, double corner_px) {
    set(colour);
    outline(box, corner_px);
    cairo_fill(context_.get());
}

void Canvas::frame(const Box& box, const Rgb& colour) {
    set(colour);
    cairo_set_line_width(context_.get(), 1.0);
    outline({box.x - 0.5, box.y - 0.5, box.width + 1.0, box.height + 1.0}, 0.0);
    cairo_stroke(context_.get());
}

void Canvas::shade(const Box& box, const Rgb& top, const Rgb& bottom, double corner_px) {
    cairo_pattern_t* pattern = cairo_pattern_create_linear(0.0, box.y, 0.0, box.y + box.height);
    cairo_pattern_add_color_stop_rgb(pattern, 0.0, top[0], top[1], top[2]);
    cairo_pattern_add_color_stop_rgb(pattern, 1.0, bottom[0], bottom[1], bottom[2]);
    cairo_set_source(context_.get(), pattern);
    outline(box, corner_px);
    cairo_fill(context_.get());
    cairo_pattern_destroy(pattern);
}

void Canvas::shadow(const Box& within, double x, double y, double half_width, double half_height) {
    cairo_t* c = context_.get();
    cairo_pattern_t* pattern = cairo_pattern_create_radial(0.0, 0.0, 0.35, 0.0, 0.0, 1.0);
    cairo_pattern_add_color_stop_rgba(pattern, 0.0, 0.0, 0.0, 0.0, 0.42);
    cairo_pattern_add_color_stop_rgba(pattern, 0.5, 0.0, 0.0, 0.0, 0.16);
    cairo_pattern_add_color_stop_rgba(pattern, 1.0, 0.0, 0.0, 0.0, 0.0);
    cairo_save(c);
    cairo_rectangle(c, within.x, within.y, within.width, within.height);
    cairo_clip(c);
    cairo_translate(c, x, y);
    cairo_scale(c, half_width, half_height);
    cairo_set_source(c, pattern);
    cairo_arc(c, 0.0, 0.0, 1.0, 0.0, 2.0 * kPi);
    cairo_fill(c);
    cairo_restore(c);
    cairo_pattern_destroy(pattern);
}

void Canvas::image(double x, double y, const PixelImage& image) {
    const auto width = static_cast<int>(image.width);
    const auto height = static_cast<int>(image.height);
    cairo_surface_t* source = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    unsigned char* rows = cairo_image_surface_get_data(source);
    if (rows != nullptr) {
        cairo_surface_flush(source);
        const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(source));
        for (std::size_t row = 0; row < image.height; ++row)
            std::memcpy(rows + row * stride, image.argb.data() + row * image.width, image.width * 4);
        cairo_surface_mark_dirty(source);
        cairo_set_source_surface(context_.get(), source, x, y);
        cairo_paint(context_.get());
    }
    cairo_surface_destroy(source);
}

Result<std::vector<std::byte>> Canvas::png() {
    const cairo_status_t drawn = cairo_status(context_.get());
    std::vector<std::byte> bytes;
    const cairo_status_t written = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
    const cairo_status_t status = drawn != CAIRO_STATUS_SUCCESS ? drawn : written;
    if (status == CAIRO_STATUS_SUCCESS) return bytes;
    return Error{ErrorCode::out_of_room,
                 std::string("cannot draw the picture: ") + cairo_status_to_string(status)};
}

}  // namespace psicarve::verify
