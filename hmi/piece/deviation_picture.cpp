// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/deviation_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "hmi/picture/deviation_map.hpp"
#include "hmi/picture/sheet.hpp"
#include "shared/base/units.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::piece {
namespace {

using namespace verify::sheet;
using verify::Box;
using verify::Canvas;
using verify::Rgb;
using Align = Canvas::Align;

constexpr Box kUnrolled{64.0, 100.0, 400.0, 380.0};
constexpr Box kScale{484.0, 100.0, 14.0, 380.0};
constexpr Box kBins{640.0, 100.0, 110.0, 380.0};
// The colours come from a scale of whole steps.
constexpr std::int64_t kSteps = 1000;
constexpr double kLeastReach_mm = 0.01;

float largest_of(const PieceDeviation& deviation, std::size_t first_row, std::size_t end_row,
                 std::size_t first_column, std::size_t end_column) {
    float largest = 0.0F;
    for (std::size_t row = first_row; row < end_row; ++row) {
        for (std::size_t column = first_column; column < end_column; ++column) {
            const float distance = deviation.distance_mm[row * deviation.column_count + column];
            if (std::abs(distance) > std::abs(largest)) largest = distance;
        }
    }
    return largest;
}

std::uint32_t pixel_of(const Rgb& colour) {
    std::uint32_t argb = 0xFF000000U;
    for (std::size_t k = 0; k < 3; ++k)
        argb |= static_cast<std::uint32_t>(std::lround(std::clamp(colour[k], 0.0, 1.0) * 255.0))
                << (16U - 8U * k);
    return argb;
}

verify::PixelImage unrolled(const PieceDeviation& deviation, const verify::DeviationScale& scale,
                            double full_mm) {
    const auto width = static_cast<std::size_t>(kUnrolled.width);
    const auto height = static_cast<std::size_t>(kUnrolled.height);
    const std::size_t rows = deviation.distance_mm.size() / std::max<std::size_t>(1, deviation.column_count);
    verify::PixelImage image{width, height, std::vector<std::uint32_t>(width * height, pixel_of(kPaper))};
    if (rows == 0) return image;
    for (std::size_t y = 0; y < height; ++y) {
        const std::size_t up = height - 1 - y;
        const std::size_t row = up * rows / height;
        const std::size_t end_row = std::max(row + 1, (up + 1) * rows / height);
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t column = x * deviation.column_count / width;
            const std::size_t end = std::max(column + 1, (x + 1) * deviation.column_count / width);
            const double distance = largest_of(deviation, row, end_row, column, end);
            image.argb[y * width + x] = pixel_of(scale.colour(distance / full_mm * kSteps));
        }
    }
    return image;
}

void draw_axes(Canvas& canvas, const PieceDeviation& deviation) {
    canvas.frame(kUnrolled, kFaint);
    draw_degrees(canvas, kUnrolled, "direction");
    for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double mm = deviation.bottom_mm + part * (deviation.top_mm - deviation.bottom_mm);
        draw_height(canvas, kUnrolled, part, format("%.1f", mm));
    }
    canvas.text(kUnrolled.x - 7.0, kUnrolled.y - 8.0, "Y mm", kLabel, Align::right);
}

void draw_scale(Canvas& canvas, const verify::DeviationScale& scale, double full_mm) {
    const auto steps = static_cast<int>(kScale.height);
    for (int row = 0; row < steps; ++row) {
        const double part = 1.0 - 2.0 * (row + 0.5) / steps;
        canvas.fill({kScale.x, kScale.y + row, kScale.width, 1.0}, scale.colour(part * kSteps));
    }
    canvas.frame(kScale, kFaint);
    for (const double part : {1.0, 0.5, 0.0, -0.5, -1.0}) {
        const double y = kScale.y + kScale.height * (1.0 - part) / 2.0;
        canvas.text(kScale.x + kScale.width + 6.0, y + 4.0, format("%+.3g", part * full_mm), kLabel);
    }
    canvas.text(kScale.x, kScale.y - 8.0, "mm", kLabel);
    canvas.text(kScale.x + kScale.width + 6.0, kScale.y + 20.0, "left over", kLabel);
    canvas.text(kScale.x + kScale.width + 6.0, kScale.y + kScale.height - 14.0, "gouge", kLabel);
}

void draw_histogram(Canvas& canvas, const PieceDeviation& deviation, const verify::DeviationScale& scale,
                    double full_mm) {
    const std::size_t bins = deviation.histogram.size();
    const double step = kBins.height / static_cast<double>(bins);
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const double y = kBins.y + kBins.height - static_cast<double>(bin + 1) * step;
        const double part = deviation.place_count > 0 ? static_cast<double>(deviation.histogram[bin]) /
                                                            static_cast<double>(deviation.place_count)
                                                      : 0.0;
        const double low_mm = bin == 0 ? -2.0 : kDeviationBounds_mm[bin - 1];
        const double high_mm = bin + 1 == bins ? 2.0 : kDeviationBounds_mm[bin];
        const Box bar{kBins.x, y + 4.0, std::max(1.0, part * kBins.width), step - 8.0};
        canvas.fill(bar, scale.colour(0.5 * (low_mm + high_mm) / full_mm * kSteps));
        canvas.frame(bar, kFaint);
        canvas.text(kBins.x + bar.width + 5.0, y + step / 2.0 + 4.0, format("%.1f %%", 100.0 * part), kLabel);
        if (bin + 1 < bins) canvas.text(kBins.x - 8.0, y + 4.0, format("%+g", high_mm), kLabel, Align::right);
    }
    canvas.text(kBins.x - 40.0, kBins.y - 8.0, "places by mm", kHeading);
}

}  // namespace

Result<std::vector<std::byte>> deviation_png(const PieceDeviation& deviation, const std::string& model_name) {
    Canvas canvas = blank();
    const verify::DeviationScale scale(kSteps);
    const double full_mm = colour_reach_mm(deviation, kLeastReach_mm);
    canvas.text(20.0, 38.0, model_name.empty() ? "unnamed model" : model_name, kTitle, Align::left,
                kWidth_px - 40.0);
    canvas.text(20.0, 60.0,
                format("gouge at most %.3f mm, left over at most %.3f mm; cells of %.2f mm",
                       deviation.gouge.max_mm, deviation.leftover.max_mm, deviation.cell_mm),
                kText);
    canvas.text(kUnrolled.x, kUnrolled.y - 8.0, "deviation of the piece from the model", kHeading);
    canvas.image(kUnrolled.x, kUnrolled.y, unrolled(deviation, scale, full_mm));
    draw_axes(canvas, deviation);
    draw_scale(canvas, scale, full_mm);
    draw_histogram(canvas, deviation, scale, full_mm);
    return canvas.png();
}

Result<void> write_deviation_picture(const std::string& path, const PieceDeviation& deviation,
                                     const std::string& model_name) {
    const auto png = deviation_png(deviation, model_name);
    if (!png) return png.error();
    return write_file_atomically(path, *png);
}

}  // namespace psicarve::piece
