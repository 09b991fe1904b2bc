// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/picture/sheet.hpp"

#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::verify::sheet {

void draw_view(Canvas& canvas, const Box& box, const PieceGrid& grid, double azimuth_deg, double px_per_mm) {
    canvas.shade(box, {0.87, 0.89, 0.91}, {0.73, 0.76, 0.79}, 8.0);
    const double half_height_mm = static_cast<double>(grid.top_mm - grid.bottom_mm) / 2.0;
    double foot_mm = 0.0;
    for (std::size_t c = 0; c < grid.columns; ++c) {
        const Vec3& p = grid.at(0, c).position_mm;
        foot_mm = std::max(foot_mm, static_cast<double>(std::hypot(p.x, p.y)));
    }
    const double foot_y = box.y + box.height / 2.0 + half_height_mm * std::cos(kElevation_rad) * px_per_mm;
    canvas.shadow(box, box.x + box.width / 2.0, foot_y + 2.0, 1.25 * foot_mm * px_per_mm,
                  1.35 * foot_mm * px_per_mm * std::sin(kElevation_rad));
    const PieceCamera camera{.azimuth_rad = rad_from_deg(azimuth_deg),
                             .elevation_rad = kElevation_rad,
                             .px_per_mm = px_per_mm,
                             .width_px = static_cast<std::size_t>(box.width),
                             .height_px = static_cast<std::size_t>(box.height)};
    canvas.image(box.x, box.y, draw_piece(grid, camera));
    canvas.text(box.x + box.width / 2.0, box.y + box.height + 17.0,
                format("seen from %.0f\u00b0", azimuth_deg), kLabel, Canvas::Align::centre);
}

void draw_degrees(Canvas& canvas, const Box& map, const char* name) {
    const double bottom = map.y + map.height;
    for (const int degrees : {0, 90, 180, 270, 360}) {
        const double x = map.x + map.width * degrees / kDegPerRev;
        canvas.line(x, bottom, x, bottom + 4.0, kFaint);
        canvas.text(x, bottom + 17.0, format("%d\u00b0", degrees), kLabel, Canvas::Align::centre);
    }
    canvas.text(map.x + map.width / 2.0, bottom + 33.0, name, kLabel, Canvas::Align::centre);
}

void draw_height(Canvas& canvas, const Box& map, double part, const std::string& text) {
    const double y = map.y + map.height * (1.0 - part);
    canvas.line(map.x - 4.0, y, map.x, y, kFaint);
    canvas.text(map.x - 7.0, y + 4.0, text, kLabel, Canvas::Align::right);
}

}  // namespace psicarve::verify::sheet
