// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

// CSS: 96 pixels to the inch, and a user unit is a pixel.
inline constexpr double kMmPerInch = 25.4;
inline constexpr double kSvgUnitsPerInch = 96.0;

/// Numbers of an attribute, between blanks and commas.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text) : text_(text) {}

    std::optional<double> next() noexcept;
    /// An arc's flag: one character, which may touch the next number.
    std::optional<bool> next_flag() noexcept;
    /// Takes the next character if it is a letter; else stays where it is.
    char next_letter() noexcept;
    bool at_end() noexcept;
    std::string_view rest() const noexcept { return text_; }

private:
    void skip_gap() noexcept;
    std::string_view text_;
};

/// "10", "1.5mm", "2in", "50%" in user units; a percentage is of `whole`. Nothing where it is no length.
std::optional<double> svg_length(std::string_view text, double whole);

/// A transform list as attributes have it, or CSS with its units; nothing where it is invalid, or not of a
/// plane.
std::optional<Affine> svg_transform(std::string_view text);
/// "10px 50%", "center", "left top": the origin of a CSS transform [user units]; the sides are those of the
/// viewport. Nothing where it is invalid.
std::optional<Point> svg_origin(std::string_view text, double width, double height);

/// Dashes and gaps in turn, an even number of them [user units]; none where strokes are whole. Nothing where
/// the list is wrong: then it is ignored.
std::optional<std::vector<double>> svg_dashes(std::string_view text, double whole);

/// Draws a path's data up to the first fault, as the standard requires. False where there is one.
bool draw_svg_path(std::string_view data, PathMaker& maker);

}  // namespace psicarve::flat
