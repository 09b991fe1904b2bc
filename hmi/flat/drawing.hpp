// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::flat {

struct Point {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// x' = a x + c y + e, y' = b x + d y + f: as SVG's matrix(a b c d e f).
struct Affine {
    double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

    Point apply(Point p) const noexcept { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    /// Transforms a difference of points.
    Point turn(Point p) const noexcept { return {a * p.x + c * p.y, b * p.x + d * p.y}; }
};
/// First `inner`, then `outer`.
Affine after(const Affine& outer, const Affine& inner) noexcept;

/// Dashes and gaps in turn along a stroke, an even number of them; none where the stroke is whole.
struct Dashes {
    std::vector<double> lengths_mm;
    double offset_mm = 0.0;  ///< where in the dashes the stroke begins
};

/// A stroke of straight pieces [mm], y upwards.
struct Path {
    std::vector<Point> points;  ///< a closed one does not repeat its first point
    bool is_closed = false;
    bool is_filled = false;  ///< an outline even where the stroke stays open
    double width_mm = 0.0;   ///< of the stroke, where the drawing gives one
    bool is_shown = true;    ///< false: neither filled nor stroked, an invisible frame
    Dashes dashes{};         ///< of an engraved stroke; an outline has none
};

/// The lines of an SVG or DXF file.
struct Drawing {
    std::vector<Path> paths;
    std::string format;                 ///< "SVG", "DXF"
    std::vector<std::string> warnings;  ///< the parts left out
};

// Curves become straight pieces no farther from them than this: a fifth of a usual pulse.
inline constexpr double kFlatness_mm = 0.0005;
// A drawing with more points is refused, and no file makes us hold more.
inline constexpr std::size_t kMostDrawingPoints = 2'000'000;

/// Makes paths of pen strokes. The pen's coordinates go through `placement`; the paths are in mm. Once the
/// budget is spent or a number is not finite, further calls do nothing: call `check` in the end.
class PathMaker {
public:
    void place(const Affine& placement) { placement_ = placement; }
    void fill(bool is_filled) { is_filled_ = is_filled; }
    void stroke(double width_mm, bool is_shown) {
        width_mm_ = width_mm;
        is_shown_ = is_shown;
    }
    const Affine& placement() const noexcept { return placement_; }

    void move_to(Point to);
    void line_to(Point to);
    void quadratic_to(Point control, Point to);
    void cubic_to(Point control_1, Point control_2, Point to);
    /// Along centre + cos(t) u + sin(t) v, from t = from to t = from + sweep [rad]; begins where the pen is.
    void ellipse(Point centre, Point u, Point v, double from_rad, double sweep_rad);
    /// SVG's arc: radii, turn of the ellipse, which of the four arcs.
    void arc_to(double radius_x, double radius_y, double turn_rad, bool is_large, bool is_positive, Point to);
    /// A point that is already in the drawing's mm.
    void placed_point(Point point);
    void close();
    /// Ends a stroke that stays open.
    void end();

    Point pen() const noexcept { return pen_; }
    bool is_over() const noexcept { return is_spent_ || is_not_finite_; }
    /// "FILE: ..." when there were too many points, or invalid numbers.
    Result<void> check(const std::string& file) const;
    std::vector<Path> take() { return std::move(paths_); }
    const std::vector<Path>& paths() const noexcept { return paths_; }
    /// Dashes all paths from this one on; where `in_length` is more than 0, lengths and offset are given for
    /// paths of that total length, else in mm.
    void dash(std::size_t first_path, const Dashes& dashes, double in_length);

private:
    void add(Point placed);
    void finish(bool is_closed);

    Affine placement_;
    Point pen_;    ///< before `placement_`
    Point start_;  ///< of the stroke, likewise
    std::vector<Point> points_;
    std::vector<Path> paths_;
    std::size_t count_ = 0;
    bool is_filled_ = false;
    double width_mm_ = 0.0;
    bool is_shown_ = true;
    bool is_spent_ = false;
    bool is_not_finite_ = false;
};

/// "FILE: more than 2000000 points ...".
Error too_many_points(const std::string& file);

/// ": line 3: <path> is not right": why a drawing has no lines, if its warnings say so; else empty.
std::string why_without_lines(const Drawing& drawing);

/// The bounding box of all points; false when there is none.
bool box_of(const std::vector<Path>& paths, Point& least, Point& most);

}  // namespace psicarve::flat
