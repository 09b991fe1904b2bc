// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/picture/picture.hpp"

#include <algorithm>
#include <cmath>

#include "hmi/picture/deviation_map.hpp"
#include "hmi/picture/piece_grid.hpp"
#include "hmi/picture/piece_view.hpp"
#include "hmi/picture/sheet.hpp"
#include "shared/base/units.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::verify {

namespace {

using namespace sheet;
using Align = Canvas::Align;

constexpr Rgb kGreen{0.11, 0.52, 0.27};
constexpr Rgb kRed{0.75, 0.13, 0.12};
constexpr Canvas::Font kSmall{9.5, false, kFaint};

constexpr Box kFirstView{20.0, 78.0, 216.0, 404.0};
constexpr Box kSecondView{246.0, 78.0, 216.0, 404.0};
constexpr Box kMap{510.0, 100.0, 180.0, 360.0};
constexpr Box kBar{712.0, 100.0, 12.0, 360.0};

/// 1, 2 or 5 times a power of ten, at most `most`.
double round_length(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= most) return factor * power;
    }
    return power;
}

MapShows shown_of(const PictureCaption& caption) {
    if (caption.is_of_carved_alone) return MapShows::carved;
    return caption.is_of_part ? MapShows::asked_for : MapShows::all;
}

void draw_title(Canvas& canvas, const PieceGrid& grid, const CarvedSurface& surface,
                const PictureCaption& caption) {
    const Canvas::Font badge{13.0, true, {1.0, 1.0, 1.0}};
    const bool is_good = caption.verified && !caption.has_lost_steps;
    const std::string verdict = verdict_of(caption);
    const double badge_width = canvas.text_width(verdict, badge) + 22.0;
    canvas.fill({kWidth_px - 20.0 - badge_width, 18.0, badge_width, 25.0}, is_good ? kGreen : kRed, 12.5);
    canvas.text(kWidth_px - 20.0 - badge_width / 2.0, 35.0, verdict, badge, Align::centre);
    canvas.text(20.0, 38.0, caption.model_name.empty() ? "unnamed job" : caption.model_name, kTitle,
                Align::left, kWidth_px - 60.0 - badge_width);
    const double diameter_mm = 2.0 * static_cast<double>(grid.radius_mm);
    const double height_mm = static_cast<double>(grid.top_mm - grid.bottom_mm);
    const double pulse_mm = 1.0 / surface.pulses_per_mm();
    canvas.text(20.0, 60.0,
                format("%u layers \u00d7 %u points a head    \u2300 %.1f mm, %.1f mm high    ",
                       caption.layers, caption.points, diameter_mm, height_mm) +
                    format("max deviation %lld pulses (%.3f mm)",
                           static_cast<long long>(caption.max_deviation_pulses),
                           static_cast<double>(caption.max_deviation_pulses) * pulse_mm) +
                    (caption.is_of_carved_alone ? " of what was carved" : ""),
                kText);
}

void draw_scale_bar(Canvas& canvas, double px_per_mm) {
    const double length_mm = round_length(80.0 / px_per_mm);
    const double length_px = length_mm * px_per_mm;
    const double x = (kFirstView.x + kSecondView.x + kSecondView.width - length_px) / 2.0;
    const double y = kHeight_px - 18.0;
    canvas.line(x, y, x + length_px, y, kInk, 2.0);
    canvas.line(x, y - 4.0, x, y + 4.0, kInk, 2.0);
    canvas.line(x + length_px, y - 4.0, x + length_px, y + 4.0, kInk, 2.0);
    canvas.text(x + length_px + 8.0, y + 4.0, format("%g mm", length_mm), kLabel);
}

void draw_map_axes(Canvas& canvas, const PieceGrid& grid) {
    canvas.frame(kMap, kFaint);
    draw_degrees(canvas, kMap, "direction \u03c8");
    const double bottom_mm = static_cast<double>(grid.bottom_mm);
    const double height_mm = static_cast<double>(grid.top_mm) - bottom_mm;
    const double step_mm = round_length(height_mm / 3.0);
    const auto first = static_cast<int>(std::ceil(bottom_mm / step_mm - 0.01));
    const auto last = static_cast<int>(std::floor((bottom_mm + height_mm) / step_mm + 1e-6));
    for (int n = first; n <= last; ++n) {
        const double mm = n * step_mm;
        draw_height(canvas, kMap, (mm - bottom_mm) / height_mm, format("%g", mm));
    }
    canvas.text(kMap.x - 7.0, kMap.y - 8.0, "Y mm", kLabel, Align::right);
}

void draw_colour_bar(Canvas& canvas, const DeviationScale& scale, double pulse_mm) {
    const auto reach = static_cast<double>(scale.reach_pulses());
    const auto steps = static_cast<int>(kBar.height);
    for (int row = 0; row < steps; ++row) {
        const double pulses = reach * (1.0 - 2.0 * (row + 0.5) / steps);
        canvas.fill({kBar.x, kBar.y + row, kBar.width, 1.0}, scale.colour(pulses));
    }
    canvas.frame(kBar, kFaint);
    const double x = kBar.x + kBar.width + 7.0;
    const auto label = [&](double part, double y) {
        const auto pulses = static_cast<long long>(part * reach);
        canvas.text(x, y, format(pulses == 0 ? "%lld" : "%+lld", pulses), kLabel);
        canvas.text(x, y + 11.0, format("%.3g mm", static_cast<double>(pulses) * pulse_mm), kSmall);
    };
    for (const double part : {1.0, 0.5, 0.0, -0.5, -1.0}) {
        if (std::abs(part) == 0.5 && (scale.reach_pulses() % 2 != 0)) continue;
        const double y = kBar.y + kBar.height * (1.0 - part) / 2.0;
        canvas.line(kBar.x + kBar.width, y, kBar.x + kBar.width + 4.0, y, kFaint);
        label(part, part == 1.0 ? y + 9.0 : part == -1.0 ? y - 11.0 : y + 1.0);
    }
    canvas.text(kBar.x - 2.0, kBar.y - 8.0, "pulses", kLabel);
    canvas.text(x, kBar.y + 33.0, "left on", kSmall);
    canvas.text(x, kBar.y + kBar.height - 24.0, "too deep", kSmall);
}

/// Below the colour bar.
void draw_uncarved_key(Canvas& canvas) {
    const Box key{kBar.x, kBar.y + kBar.height + 12.0, kBar.width, kBar.width};
    canvas.fill(key, kUncarvedColour);
    canvas.frame(key, kFaint);
    canvas.text(key.x + key.width + 7.0, key.y + key.height - 2.0, "not carved", kSmall);
}

}  // namespace

std::string verdict_of(const PictureCaption& caption) {
    if (!caption.verified) return "NOT verified";
    if (caption.has_lost_steps) return "STEPS LOST";
    if (caption.is_dry) return "dry run, verified on the pins";
    return caption.is_of_carved_alone ? "verified as far as it went" : "verified on the pins";
}

PictureCaption caption_of(const JobView& job, const VerifyReport& report) {
    PictureCaption caption;
    caption.model_name = std::string(job.source_name());
    caption.layers = job.layer_count();
    caption.points = job.point_count();
    caption.verified = report.ok;
    caption.max_deviation_pulses = report.max_deviation_pulses;
    caption.is_of_carved_alone = report.is_of_carved_alone();
    caption.is_of_part = !report.is_whole_job;
    caption.is_dry = report.is_dry;
    return caption;
}

Result<std::vector<std::byte>> picture_png(const CarvedSurface& surface, const PictureCaption& caption) {
    const PieceGrid grid = make_piece_grid(surface);
    Canvas canvas = blank();
    draw_title(canvas, grid, surface, caption);
    const double px_per_mm = fitting_px_per_mm(grid, kElevation_rad, kFirstView.width, kFirstView.height);
    draw_view(canvas, kFirstView, grid, kFirstAzimuth_deg, px_per_mm);
    draw_view(canvas, kSecondView, grid, kSecondAzimuth_deg, px_per_mm);
    draw_scale_bar(canvas, px_per_mm);
    const DeviationScale scale(caption.max_deviation_pulses);
    const MapShows shows = shown_of(caption);
    canvas.text(kMap.x, kMap.y - 8.0, "deviation from the job", kHeading);
    canvas.image(kMap.x, kMap.y,
                 draw_deviation_map(surface, scale, static_cast<std::size_t>(kMap.width),
                                    static_cast<std::size_t>(kMap.height), shows));
    draw_map_axes(canvas, grid);
    draw_colour_bar(canvas, scale, 1.0 / surface.pulses_per_mm());
    if (shows != MapShows::all) draw_uncarved_key(canvas);
    return canvas.png();
}

Result<void> write_picture(const std::string& path, const CarvedSurface& surface,
                           const PictureCaption& caption) {
    auto png = picture_png(surface, caption);
    if (!png) return png.error();
    return write_file_atomically(path, *png);
}

}  // namespace psicarve::verify
