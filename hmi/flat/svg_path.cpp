// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string_view>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/svg_values.hpp"
#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

/// Reads path data command by command. A letter that is left out repeats the last one.
class PathDataWalk {
public:
    PathDataWalk(std::string_view data, PathMaker& maker) : numbers_(data), maker_(maker) {}

    bool walk() {
        char command = '\0';
        while (!numbers_.at_end()) {
            const char letter = numbers_.next_letter();
            if (letter == '\0') {
                if (command == '\0' || command == 'Z' || command == 'z') return false;
                if (command == 'M') command = 'L';  // more points after a move are lines
                if (command == 'm') command = 'l';
            } else {
                if (command == '\0' && letter != 'M' && letter != 'm') return false;
                command = letter;
            }
            is_relative_ = command >= 'a';
            if (!draw(is_relative_ ? static_cast<char>(command - 'a' + 'A') : command)) return false;
        }
        return true;
    }

private:
    /// The next number, added to `from` when the command is a small letter.
    std::optional<double> coordinate(double from) {
        const auto value = numbers_.next();
        if (!value) return std::nullopt;
        return is_relative_ ? from + *value : *value;
    }
    std::optional<Point> point() {
        const Point pen = maker_.pen();
        const auto x = coordinate(pen.x);
        const auto y = x ? coordinate(pen.y) : std::nullopt;
        if (!y) return std::nullopt;
        return Point{*x, *y};
    }
    /// The last control point seen from the other side; the pen itself after another kind of command.
    Point mirrored(char kind) const {
        const Point pen = maker_.pen();
        if (control_kind_ != kind) return pen;
        return {2.0 * pen.x - control_.x, 2.0 * pen.y - control_.y};
    }
    void keep_control(char kind, Point control) {
        control_kind_ = kind;
        control_ = control;
    }

    bool draw(char command) {
        if (command != 'C' && command != 'S' && command != 'Q' && command != 'T') control_kind_ = '\0';
        switch (command) {
            case 'M':
            case 'L': {
                const auto to = point();
                if (to && command == 'M') maker_.move_to(*to);
                if (to && command == 'L') maker_.line_to(*to);
                return to.has_value();
            }
            case 'H': {
                const auto x = coordinate(maker_.pen().x);
                if (x) maker_.line_to({*x, maker_.pen().y});
                return x.has_value();
            }
            case 'V': {
                const auto y = coordinate(maker_.pen().y);
                if (y) maker_.line_to({maker_.pen().x, *y});
                return y.has_value();
            }
            case 'C':
            case 'S':
                return draw_cubic(command == 'S');
            case 'Q':
            case 'T':
                return draw_quadratic(command == 'T');
            case 'A':
                return draw_arc();
            case 'Z':
                maker_.close();
                return true;
            default:
                return false;
        }
    }

    bool draw_cubic(bool is_smooth) {
        const auto first = is_smooth ? std::optional(mirrored('C')) : point();
        const auto second = first ? point() : std::nullopt;
        const auto to = second ? point() : std::nullopt;
        if (!to) return false;
        maker_.cubic_to(*first, *second, *to);
        keep_control('C', *second);
        return true;
    }

    bool draw_quadratic(bool is_smooth) {
        const auto control = is_smooth ? std::optional(mirrored('Q')) : point();
        const auto to = control ? point() : std::nullopt;
        if (!to) return false;
        maker_.quadratic_to(*control, *to);
        keep_control('Q', *control);
        return true;
    }

    bool draw_arc() {
        const auto rx = numbers_.next();
        const auto ry = rx ? numbers_.next() : std::nullopt;
        const auto turn_deg = ry ? numbers_.next() : std::nullopt;
        const auto is_large = turn_deg ? numbers_.next_flag() : std::nullopt;
        const auto is_positive = is_large ? numbers_.next_flag() : std::nullopt;
        const auto to = is_positive ? point() : std::nullopt;
        if (!to) return false;
        maker_.arc_to(*rx, *ry, rad_from_deg(*turn_deg), *is_large, *is_positive, *to);
        return true;
    }

    SvgNumbers numbers_;
    PathMaker& maker_;
    bool is_relative_ = false;
    char control_kind_ = '\0';
    Point control_;
};

}  // namespace

bool draw_svg_path(std::string_view data, PathMaker& maker) {
    maker.move_to({});  // where the first move begins, also one with a small letter
    const bool is_right = PathDataWalk(data, maker).walk();
    maker.end();
    return is_right;
}

}  // namespace psicarve::flat
