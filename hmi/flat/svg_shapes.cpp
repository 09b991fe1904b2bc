// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/svg_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "hmi/flat/svg_values.hpp"
#include "shared/base/trimmed.hpp"
#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

/// An element's lengths; remembers an invalid one.
class Lengths {
public:
    Lengths(const SvgElement& element, const SvgViewport& port)
        : element_(element), port_(port), diagonal_(std::hypot(port.width, port.height) / std::sqrt(2.0)) {}

    double x(std::string_view name) { return get(name, port_.width).value_or(0.0); }
    double y(std::string_view name) { return get(name, port_.height).value_or(0.0); }
    // Sides and radii are never less than 0. Nothing where none is given.
    std::optional<double> width(std::string_view name) { return positive(get(name, port_.width)); }
    std::optional<double> height(std::string_view name) { return positive(get(name, port_.height)); }
    std::optional<double> radius(std::string_view name) { return positive(get(name, diagonal_)); }
    bool are_right() const noexcept { return are_right_; }

private:
    std::optional<double> get(std::string_view name, double whole) {
        const std::string_view text = trimmed(element_.get(name));
        if (text.empty() || text == "auto") return std::nullopt;
        const auto length = svg_length(text, whole);
        are_right_ = are_right_ && length;
        return length;
    }
    std::optional<double> positive(std::optional<double> length) {
        are_right_ = are_right_ && !(length && *length < 0.0);
        return length;
    }
    const SvgElement& element_;
    SvgViewport port_;
    double diagonal_;
    bool are_right_ = true;
};

void draw_ellipse(PathMaker& maker, Point centre, double radius_x, double radius_y) {
    if (!(radius_x > 0.0) || !(radius_y > 0.0)) return;
    maker.move_to({centre.x + radius_x, centre.y});
    maker.ellipse(centre, {radius_x, 0.0}, {0.0, radius_y}, 0.0, 2.0 * kPi);
    maker.close();
}

bool draw_rect(Lengths& lengths, PathMaker& maker) {
    const double x = lengths.x("x");
    const double y = lengths.y("y");
    const double width = lengths.width("width").value_or(0.0);
    const double height = lengths.height("height").value_or(0.0);
    const auto rx_given = lengths.width("rx");
    const auto ry_given = lengths.height("ry");
    if (!lengths.are_right()) return false;
    if (!(width > 0.0) || !(height > 0.0)) return true;
    const double rx = std::clamp(rx_given.value_or(ry_given.value_or(0.0)), 0.0, 0.5 * width);
    const double ry = std::clamp(ry_given.value_or(rx_given.value_or(0.0)), 0.0, 0.5 * height);
    maker.move_to({x + rx, y});
    maker.line_to({x + width - rx, y});
    if (rx > 0.0 && ry > 0.0) maker.arc_to(rx, ry, 0.0, false, true, {x + width, y + ry});
    maker.line_to({x + width, y + height - ry});
    if (rx > 0.0 && ry > 0.0) maker.arc_to(rx, ry, 0.0, false, true, {x + width - rx, y + height});
    maker.line_to({x + rx, y + height});
    if (rx > 0.0 && ry > 0.0) maker.arc_to(rx, ry, 0.0, false, true, {x, y + height - ry});
    maker.line_to({x, y + ry});
    if (rx > 0.0 && ry > 0.0) maker.arc_to(rx, ry, 0.0, false, true, {x + rx, y});
    maker.close();
    return true;
}

bool draw_round(std::string_view name, Lengths& lengths, PathMaker& maker) {
    const Point centre{lengths.x("cx"), lengths.y("cy")};
    const bool is_circle = name == "circle";
    const auto rx = is_circle ? lengths.radius("r") : lengths.width("rx");
    const auto ry = is_circle ? rx : lengths.height("ry");
    if (!lengths.are_right()) return false;
    draw_ellipse(maker, centre, rx.value_or(ry.value_or(0.0)), ry.value_or(rx.value_or(0.0)));
    return true;
}

bool draw_line(Lengths& lengths, PathMaker& maker) {
    const Point from{lengths.x("x1"), lengths.y("y1")};
    const Point to{lengths.x("x2"), lengths.y("y2")};
    if (!lengths.are_right()) return false;
    maker.move_to(from);
    maker.line_to(to);
    maker.end();
    return true;
}

/// An odd number ends the list before it.
bool draw_points(std::string_view text, bool is_closed, PathMaker& maker) {
    SvgNumbers numbers(text);
    bool is_first = true;
    bool is_right = true;
    while (!numbers.at_end() && is_right) {
        const auto x = numbers.next();
        const auto y = x ? numbers.next() : std::nullopt;
        is_right = y.has_value();
        if (is_right && is_first) maker.move_to({*x, *y});
        if (is_right && !is_first) maker.line_to({*x, *y});
        is_first = false;
    }
    if (is_closed) maker.close();
    maker.end();
    return is_right;
}

}  // namespace

bool draw_svg_shape(const SvgElement& element, const SvgViewport& viewport, PathMaker& maker) {
    const std::string_view name = element.name;
    if (name == "path") return draw_svg_path(element.get("d"), maker);
    if (name == "polygon" || name == "polyline") {
        return draw_points(element.get("points"), name == "polygon", maker);
    }
    Lengths lengths(element, viewport);
    if (name == "rect") return draw_rect(lengths, maker);
    if (name == "circle" || name == "ellipse") return draw_round(name, lengths, maker);
    if (name == "line") return draw_line(lengths, maker);
    return true;
}

}  // namespace psicarve::flat
