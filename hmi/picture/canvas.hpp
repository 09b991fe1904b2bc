// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cairo.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "hmi/picture/piece_view.hpp"
#include "shared/base/result.hpp"

namespace psicarve::verify {

using Rgb = std::array<double, 3>;
struct Box {
    double x;
    double y;
    double width;
    double height;
};

/// A sheet to draw on, by cairo: lines, texts, images, PNG at the end. Units are pixels, y points down.
class Canvas {
public:
    enum class Align { left, centre, right };
    struct Font {
        double size_px;
        bool bold;
        Rgb colour;
    };

    Canvas(int width_px, int height_px, const Rgb& background);

    /// Text with its baseline at y; longer than `most_px`, it is cut and ends in an ellipsis.
    void text(double x, double y, const std::string& utf8, const Font& font, Align align = Align::left,
              double most_px = 1e9);
    double text_width(const std::string& utf8, const Font& font);
    void line(double x0, double y0, double x1, double y1, const Rgb& colour, double width_px = 1.0);
    void fill(const Box& box, const Rgb& colour, double corner_px = 0.0);
    void frame(const Box& box, const Rgb& colour);
    /// Fills a box, from one colour at the top to another at the bottom.
    void shade(const Box& box, const Rgb& top, const Rgb& bottom, double corner_px);
    /// Draws the part of a soft dark ellipse that lies within the box.
    void shadow(const Box& within, double x, double y, double half_width, double half_height);
    void image(double x, double y, const PixelImage& image);

    Result<std::vector<std::byte>> png();

private:
    struct Free {
        void operator()(cairo_surface_t* surface) const noexcept { cairo_surface_destroy(surface); }
        void operator()(cairo_t* context) const noexcept { cairo_destroy(context); }
    };
    void outline(const Box& box, double corner_px);
    void set(const Rgb& colour) { cairo_set_source_rgb(context_.get(), colour[0], colour[1], colour[2]); }
    void set(const Font& font);

    std::unique_ptr<cairo_surface_t, Free> surface_;
    std::unique_ptr<cairo_t, Free> context_;
};

/// Text from outside as valid UTF-8: invalid bytes become '?'.
std::string as_utf8(const std::string& bytes);

}  // namespace psicarve::verify
