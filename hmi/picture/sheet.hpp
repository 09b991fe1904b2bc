// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

#include "hmi/picture/canvas.hpp"

/// Shared by the pictures of verify and carve: the sheet, its colours, fonts and degree axis.
namespace psicarve::verify::sheet {

constexpr int kWidth_px = 800;
constexpr int kHeight_px = 540;
constexpr Rgb kPaper{0.985, 0.985, 0.980};
constexpr Rgb kInk{0.13, 0.15, 0.18};
constexpr Rgb kFaint{0.42, 0.45, 0.49};
constexpr Canvas::Font kTitle{21.0, true, kInk};
constexpr Canvas::Font kHeading{13.0, true, kInk};
constexpr Canvas::Font kText{13.0, false, kFaint};
constexpr Canvas::Font kLabel{11.0, false, kFaint};
constexpr double kElevation_rad = 0.36;  ///< of the eye above the piece
constexpr double kFirstAzimuth_deg = 30.0;
constexpr double kSecondAzimuth_deg = 210.0;

/// An empty sheet.
inline Canvas blank() {
    return {kWidth_px, kHeight_px, kPaper};
}

/// printf into a string; at most 199 characters.
template <typename... Values>
std::string format(const char* pattern, Values... values) {
    char text[200];
    const int length = std::snprintf(text, sizeof text, pattern, values...);
    return {text, static_cast<std::size_t>(std::clamp(length, 0, static_cast<int>(sizeof text) - 1))};
}

/// A view of the piece within its box, with the direction that it is seen from below it.
void draw_view(Canvas& canvas, const Box& box, const PieceGrid& grid, double azimuth_deg, double px_per_mm);

/// 0° to 360° along the bottom of an unrolled map, with the name of the axis.
void draw_degrees(Canvas& canvas, const Box& map, const char* name);
/// Writes a height beside a map: `part` of the way up, from 0 to 1.
void draw_height(Canvas& canvas, const Box& map, double part, const std::string& text);

}  // namespace psicarve::verify::sheet
