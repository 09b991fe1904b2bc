// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/svg_values.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "shared/base/trimmed.hpp"
#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

constexpr std::size_t kMostDashes = 1000;

bool is_gap(char c) noexcept {
    return kGaps.find(c) != std::string_view::npos;
}
bool is_letter(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Takes a number off the front of the text.
std::optional<double> take_number(std::string_view& text) noexcept {
    std::string_view from = text;
    if (!from.empty() && from.front() == '+') from.remove_prefix(1);
    // from_chars reads "inf" and "nan", which are no SVG numbers.
    const std::size_t sign = !from.empty() && from.front() == '-' ? 1 : 0;
    if (from.size() <= sign || is_letter(from[sign])) return std::nullopt;
    double value = 0.0;
    const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), value);
    if (error != std::errc{}) return std::nullopt;
    from.remove_prefix(static_cast<std::size_t>(end - from.data()));
    text = from;
    return value;
}

Affine turned(double angle_deg) noexcept {
    const double angle_rad = rad_from_deg(angle_deg);
    const double cosine = std::cos(angle_rad);
    const double sine = std::sin(angle_rad);
    return {cosine, sine, -sine, cosine, 0.0, 0.0};
}

std::optional<Affine> one_transform(std::string_view name, const std::array<double, 6>& n,
                                    std::size_t count) noexcept {
    const auto shift = [](double x, double y) { return Affine{1.0, 0.0, 0.0, 1.0, x, y}; };
    if (name == "matrix" && count == 6) return Affine{n[0], n[1], n[2], n[3], n[4], n[5]};
    if (name == "translate" && (count == 1 || count == 2)) return shift(n[0], count == 2 ? n[1] : 0.0);
    if (name == "scale" && (count == 1 || count == 2)) {
        return Affine{n[0], 0.0, 0.0, count == 2 ? n[1] : n[0], 0.0, 0.0};
    }
    if (name == "rotate" && count == 1) return turned(n[0]);
    if (name == "rotate" && count == 3) {
        return after(shift(n[1], n[2]), after(turned(n[0]), shift(-n[1], -n[2])));
    }
    const auto skew = [](double x_deg, double y_deg) {
        return Affine{1.0, std::tan(rad_from_deg(y_deg)), std::tan(rad_from_deg(x_deg)), 1.0, 0.0, 0.0};
    };
    if (name == "skewX" && count == 1) return skew(n[0], 0.0);
    if (name == "skewY" && count == 1) return skew(0.0, n[0]);
    // CSS alone has these.
    if (name == "skew" && (count == 1 || count == 2)) return skew(n[0], count == 2 ? n[1] : 0.0);
    if (name == "translateX" && count == 1) return shift(n[0], 0.0);
    if (name == "translateY" && count == 1) return shift(0.0, n[0]);
    if (name == "scaleX" && count == 1) return Affine{n[0], 0.0, 0.0, 1.0, 0.0, 0.0};
    if (name == "scaleY" && count == 1) return Affine{1.0, 0.0, 0.0, n[0], 0.0, 0.0};
    return std::nullopt;
}

/// An angle in degrees, a length in user units, or a plain number, as the function's name asks.
std::optional<double> argument_of(std::string_view name, std::string_view text) {
    if (name.substr(0, 9) == "translate") return svg_length(text, std::numeric_limits<double>::quiet_NaN());
    const auto value = take_number(text);
    if (!value || text.empty()) return value;
    if (name != "rotate" && name.substr(0, 4) != "skew") return std::nullopt;
    if (text == "deg") return *value;
    if (text == "rad") return deg_from_rad(*value);
    if (text == "grad") return 0.9 * *value;
    if (text == "turn") return kDegPerRev * *value;
    return std::nullopt;
}

/// Takes a number with its unit, or a word, and the comma after it off the text. Numbers may touch:
/// "1-2.5.5".
std::string_view take_item(std::string_view& text) noexcept {
    std::string_view rest = text;
    if (take_number(rest)) {
        while (!rest.empty() && (is_letter(rest.front()) || rest.front() == '%')) rest.remove_prefix(1);
    } else {
        while (!rest.empty() && rest.front() != ',' && !is_gap(rest.front())) rest.remove_prefix(1);
    }
    const std::string_view item = text.substr(0, text.size() - rest.size());
    text = trimmed(rest);
    if (!text.empty() && text.front() == ',') text = trimmed(text.substr(1));
    return item;
}

}  // namespace

void SvgNumbers::skip_gap() noexcept {
    bool had_comma = false;
    while (!text_.empty() && (is_gap(text_.front()) || (text_.front() == ',' && !had_comma))) {
        had_comma = had_comma || text_.front() == ',';
        text_.remove_prefix(1);
    }
}

std::optional<double> SvgNumbers::next() noexcept {
    skip_gap();
    return take_number(text_);
}

std::optional<bool> SvgNumbers::next_flag() noexcept {
    skip_gap();
    if (text_.empty() || (text_.front() != '0' && text_.front() != '1')) return std::nullopt;
    const bool is_set = text_.front() == '1';
    text_.remove_prefix(1);
    return is_set;
}

char SvgNumbers::next_letter() noexcept {
    while (!text_.empty() && is_gap(text_.front())) text_.remove_prefix(1);
    if (text_.empty() || !is_letter(text_.front())) return '\0';
    const char letter = text_.front();
    text_.remove_prefix(1);
    return letter;
}

bool SvgNumbers::at_end() noexcept {
    return trimmed(text_).empty();
}

std::optional<double> svg_length(std::string_view text, double whole) {
    text = trimmed(text);
    const auto value = take_number(text);
    if (!value) return std::nullopt;
    text = trimmed(text);
    constexpr double kPerInch = kSvgUnitsPerInch;
    constexpr std::array<std::pair<std::string_view, double>, 11> kUnits{
        {{"", 1.0},
         {"px", 1.0},
         {"mm", kPerInch / kMmPerInch},
         {"cm", 10.0 * kPerInch / kMmPerInch},
         {"in", kPerInch},
         {"pt", kPerInch / 72.0},
         {"pc", kPerInch / 6.0},
         {"Q", kPerInch / kMmPerInch / 4.0},
         {"em", 16.0},
         {"rem", 16.0},
         {"ex", 8.0}}};
    if (text == "%") return *value * whole / 100.0;
    for (const auto& [name, factor] : kUnits) {
        if (text == name) return *value * factor;
    }
    return std::nullopt;
}

std::optional<Affine> svg_transform(std::string_view text) {
    Affine all;
    for (text = trimmed(text); !text.empty() && text != "none";) {
        const std::size_t open = text.find('(');
        const std::size_t close = text.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open)
            return std::nullopt;
        const std::string_view name = trimmed(text.substr(0, open));
        std::string_view arguments = trimmed(text.substr(open + 1, close - open - 1));
        std::array<double, 6> values{};
        std::size_t count = 0;
        while (!arguments.empty()) {
            const auto value = argument_of(name, take_item(arguments));
            if (!value || !std::isfinite(*value) || count == values.size()) return std::nullopt;
            values[count++] = *value;
        }
        const auto one = one_transform(name, values, count);
        if (!one) return std::nullopt;
        all = after(all, *one);
        text = trimmed(text.substr(close + 1));
        if (!text.empty() && text.front() == ',') text = trimmed(text.substr(1));
    }
    return all;
}

std::optional<Point> svg_origin(std::string_view text, double width, double height) {
    text = trimmed(text);
    const std::string_view first = take_item(text);
    const std::string_view second = take_item(text);
    const auto place = [](std::string_view word, std::string_view low, std::string_view high, double whole) {
        if (word == low) return std::optional(0.0);
        if (word == "center" || word.empty()) return std::optional(0.5 * whole);
        return word == high ? std::optional(whole) : svg_length(word, whole);
    };
    auto x = place(first, "left", "right", width);
    auto y = place(second, "top", "bottom", height);
    if (!x || !y) {  // words may stand the other way round
        x = place(second, "left", "right", width);
        y = place(first, "top", "bottom", height);
    }
    if (!x || !y) return std::nullopt;
    return Point{*x, *y};
}

std::optional<std::vector<double>> svg_dashes(std::string_view text, double whole) {
    std::vector<double> dashes;
    double sum = 0.0;
    for (text = trimmed(text); !text.empty() && text != "none";) {
        const auto length = svg_length(take_item(text), whole);
        if (!length || !(*length >= 0.0) || !std::isfinite(*length) || dashes.size() >= kMostDashes)
            return std::nullopt;
        dashes.push_back(*length);
        sum += *length;
    }
    if (!(sum > 0.0)) return std::vector<double>{};
    if (dashes.size() % 2 != 0) dashes.insert(dashes.end(), dashes.begin(), dashes.end());
    return dashes;
}

}  // namespace psicarve::flat
