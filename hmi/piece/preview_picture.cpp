// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/preview_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hmi/picture/piece_grid.hpp"
#include "hmi/picture/piece_view.hpp"
#include "hmi/picture/sheet.hpp"
#include "shared/base/units.hpp"

namespace psicarve::piece {
namespace {

using namespace verify::sheet;
using verify::Box;
using verify::Canvas;

constexpr Canvas::Font kLineFont{11.5, false, kInk};
constexpr Box kFirstView{20.0, 62.0, 226.0, 430.0};
constexpr Box kSecondView{256.0, 62.0, 226.0, 430.0};
constexpr double kTextX = 500.0;
constexpr double kTextY = 60.0;
constexpr double kNameLine = 20.0;
constexpr double kTextLine = 16.0;
constexpr std::size_t kNameEnd = 11;  // of a line: its name, filled up with blanks
constexpr double kWarningX = 36.0;
constexpr double kWarningWidth = kWidth_px - kWarningX - 20.0;
constexpr double kWarningLine = 16.0;
constexpr double kWarningGap = 5.0;
constexpr Canvas::Font kWarningSign{13.0, true, {0.76, 0.32, 0.08}};
constexpr std::size_t kPreviewPictureMostRows = 600;

verify::PieceGrid grid_of(const StockMap& piece, std::span<const std::size_t> rows) {
    const std::size_t every =
        std::max<std::size_t>(1, (rows.size() + kPreviewPictureMostRows - 1) / kPreviewPictureMostRows);
    std::vector<float> radii_mm;
    std::vector<float> heights_mm;
    for (std::size_t i = 0; i < rows.size(); i += every) {
        radii_mm.insert(radii_mm.end(), piece.row(rows[i]).begin(), piece.row(rows[i]).end());
        heights_mm.push_back(static_cast<float>(piece.height_mm(rows[i])));
    }
    return verify::make_piece_grid(piece.column_count(), std::move(radii_mm), std::move(heights_mm));
}

/// The blank's outline in a view's camera.
class BlankOutline {
public:
    BlankOutline(const BlankProfile& blank, const verify::PieceGrid& grid)
        : blank_(blank),
          middle_mm_(0.5 * (static_cast<double>(grid.bottom_mm) + static_cast<double>(grid.top_mm))),
          top_mm_(blank.height_mm > 0.0 ? blank.height_mm : static_cast<double>(grid.top_mm)) {}

    /// The largest scale at which it is within a view's box; no more than `most`.
    double fitting_px_per_mm(double azimuth_deg, const Box& box, double most) const {
        constexpr double kMargin = 0.94;
        for (const double z_mm : {0.0, top_mm_}) {
            for (int k = 0; k < kOutlineSteps; ++k) {
                const Seen seen = seen_from(azimuth_deg, rim(k, z_mm));
                most = std::min(most, 0.5 * kMargin * box.width / std::max(1e-9, std::abs(seen.right_mm)));
                most = std::min(most, 0.5 * kMargin * box.height / std::max(1e-9, std::abs(seen.up_mm)));
            }
        }
        return most;
    }

    void draw(Canvas& canvas, const Box& box, double azimuth_deg, double px_per_mm) const {
        const auto line = [&](const Place& from, const Place& to) {
            const Seen a = seen_from(azimuth_deg, from);
            const Seen b = seen_from(azimuth_deg, to);
            const double x = box.x + 0.5 * box.width;
            const double y = box.y + 0.5 * box.height;
            canvas.line(x + px_per_mm * a.right_mm, y - px_per_mm * a.up_mm, x + px_per_mm * b.right_mm,
                        y - px_per_mm * b.up_mm, kBlankInk);
        };
        for (int k = 0; k < kOutlineSteps; ++k) {
            line(rim(k, top_mm_), rim(k + 1, top_mm_));
            // Hidden lines behind the blank are left out.
            if (faces(azimuth_deg, k) || faces(azimuth_deg, k + 1)) line(rim(k, 0.0), rim(k + 1, 0.0));
            if (faces(azimuth_deg, k) != faces(azimuth_deg, k + 1)) line(rim(k, 0.0), rim(k, top_mm_));
        }
        // A cross at its own axis, on its top.
        const double arm_mm = 7.0 / px_per_mm;
        for (const auto& [x_mm, z_mm] : {std::pair{arm_mm, 0.0}, std::pair{0.0, arm_mm}}) {
            line({blank_.offset_x_mm - x_mm, blank_.offset_z_mm - z_mm, top_mm_},
                 {blank_.offset_x_mm + x_mm, blank_.offset_z_mm + z_mm, top_mm_});
        }
    }

private:
    static constexpr int kOutlineSteps = 120;
    static constexpr verify::Rgb kBlankInk{0.16, 0.36, 0.62};
    struct Place {
        double x_mm;
        double y_mm;
        double z_mm;  ///< above the table
    };
    struct Seen {
        double right_mm;
        double up_mm;
    };

    static double turn_rad(int k) { return 2.0 * kPi * k / kOutlineSteps; }
    Place rim(int k, double z_mm) const {
        return {blank_.offset_x_mm + blank_.radius_mm * std::cos(turn_rad(k)),
                blank_.offset_z_mm + blank_.radius_mm * std::sin(turn_rad(k)), z_mm};
    }
    static bool faces(double azimuth_deg, int k) {
        return std::cos(turn_rad(k) - rad_from_deg(azimuth_deg)) >= 0.0;
    }
    Seen seen_from(double azimuth_deg, const Place& at) const {
        const double azimuth_rad = rad_from_deg(azimuth_deg);
        const double ahead_mm = std::cos(azimuth_rad) * at.x_mm + std::sin(azimuth_rad) * at.y_mm;
        return {std::cos(azimuth_rad) * at.y_mm - std::sin(azimuth_rad) * at.x_mm,
                std::cos(kElevation_rad) * (at.z_mm - middle_mm_) - std::sin(kElevation_rad) * ahead_mm};
    }

    const BlankProfile& blank_;
    double middle_mm_;
    double top_mm_;
};

void draw_views(Canvas& canvas, const verify::PieceGrid& grid, const BlankProfile& blank) {
    double px_per_mm = verify::fitting_px_per_mm(grid, kElevation_rad, kFirstView.width, kFirstView.height);
    const BlankOutline outline(blank, grid);
    const bool is_known = blank.radius_mm > 0.0;
    const std::array<std::pair<Box, double>, 2> views{std::pair{kFirstView, kFirstAzimuth_deg},
                                                      std::pair{kSecondView, kSecondAzimuth_deg}};
    for (const auto& [box, azimuth_deg] : views)
        if (is_known) px_per_mm = outline.fitting_px_per_mm(azimuth_deg, box, px_per_mm);
    for (const auto& [box, azimuth_deg] : views) {
        draw_view(canvas, box, grid, azimuth_deg, px_per_mm);
        if (is_known) outline.draw(canvas, box, azimuth_deg, px_per_mm);
    }
}

/// The name at a line's begin; empty: it continues the line before.
std::string name_in(const std::string& line) {
    return line.substr(0, line.find_last_not_of(' ', kNameEnd - 1) + 1);
}

double lines_height(const std::vector<std::string>& lines) {
    double height = 2.0 * kTextLine;
    for (const std::string& line : lines) height += kTextLine + (name_in(line).empty() ? 0.0 : kNameLine);
    return height;
}

/// A text in lines that are no wider than the sheet.
std::vector<std::string> broken(Canvas& canvas, const std::string& text) {
    std::vector<std::string> lines{""};
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = verify::as_utf8(text.substr(at, end - at));
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || canvas.text_width(longer, kLineFont) <= kWarningWidth)
            lines.back() = longer;
        else
            lines.push_back(word);
        at = end + 1;
    }
    return lines;
}

}  // namespace

Result<std::vector<std::byte>> preview_png(const StockMap& piece, std::span<const std::size_t> rows,
                                           const BlankProfile& blank, const PreviewText& text) {
    Canvas measure = verify::sheet::blank();
    std::vector<std::vector<std::string>> warnings;
    double height = std::max<double>(kHeight_px, kTextY + lines_height(text.lines));
    const double warnings_y = height - 8.0;
    for (const std::string& warning : text.warnings) {
        warnings.push_back(broken(measure, warning));
        height += kWarningGap + kWarningLine * static_cast<double>(warnings.back().size());
    }
    Canvas canvas{kWidth_px, static_cast<int>(height), kPaper};
    canvas.text(20.0, 38.0, text.title, kTitle, Canvas::Align::left, kWidth_px - 40.0);
    if (rows.size() > 1) draw_views(canvas, grid_of(piece, rows), blank);
    double y = kTextY;
    for (const std::string& line : text.lines) {
        const std::string name = name_in(line);
        const std::string what = line.size() > kNameEnd ? line.substr(kNameEnd) : "";
        if (!name.empty()) canvas.text(kTextX, y += kNameLine, name, kLabel);
        canvas.text(kTextX, y += kTextLine, what, kLineFont, Canvas::Align::left, kWidth_px - kTextX - 10.0);
    }
    y = warnings_y;
    for (const auto& lines : warnings) {
        canvas.text(20.0, y + kWarningLine, "!", kWarningSign);
        for (const std::string& line : lines)
            canvas.text(kWarningX, y += kWarningLine, line, kLineFont, Canvas::Align::left, kWarningWidth);
        y += kWarningGap;
    }
    return canvas.png();
}

}  // namespace psicarve::piece
