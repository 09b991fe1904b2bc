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
    /// The letter that stands next, if it is one; else nothing moves.
    char next_letter() noexcept;
    bool at_end() noexcept;
    std::string_view rest() const noexcept { return text_; }

private:
    void skip_gap() noexcept;
    std::string_view text_;
};

/// "10", "1.5mm", "2in", "50%" in user units; a percentage is of `whole`. Nothing where it is no length.
std::optional<double> svg_length(std::string_view text, double whole);

/// A transform list as attributes have it, or CSS with its units; nothing where it is none, or none of a
/// plane.
std::optional<Affine> svg_transform(std::string_view text);
/// "10px 50%", "center", "left top": where a CSS transform turns about [user units]; the sides are those of
/// the viewport. Nothing where it is no place.
std::optional<Point> svg_origin(std::string_view text, double width, double height);

/// Dashes and gaps in turn, an even number of them [user units]; none where strokes are whole. Nothing where
/// the list is not right, which is then as if it were not there.
std::optional<std::vector<double>> svg_dashes(std::string_view text, double whole);

/// Draws a path's data as far as it is right, as the standard asks. False where it is not.
bool draw_svg_path(std::string_view data, PathMaker& maker);

}  // namespace psicarve::flat
