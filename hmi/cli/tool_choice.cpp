// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/tool_choice.hpp"

#include <charconv>
#include <cmath>
#include <vector>

#include "shared/base/decimals.hpp"

namespace psicarve::cli {

bool parse_number(std::string_view text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end != std::string_view::npos) text.remove_prefix(end + 1);
    }
    return parts;
}

}  // namespace

Result<void> read_tool(const std::string& text, ToolProfile& tool) {
    if (text.empty()) return {};
    const auto parts = split(text, ':');
    const auto shape = tool_shape_from_name(parts[0]);
    const std::size_t wanted = shape == ToolShape::point ? 1 : shape == ToolShape::vee ? 3 : 2;
    const ProfileBounds sizes_mm = profile_bounds("tool.diameter_mm");
    const bool is_good = shape && parts.size() == wanted &&
                         (wanted < 2 || parse_number(parts[1], tool.diameter_mm)) &&
                         (wanted < 3 || parse_number(parts[2], tool.angle_deg));
    if (!is_good || !sizes_mm.hold(tool.diameter_mm) ||
        !profile_bounds("tool.angle_deg").hold(tool.angle_deg)) {
        return Error{ErrorCode::bad_usage, "--tool: '" + text +
                                               "' is none of point, ball:MM, flat:MM, vee:MM:DEGREES (as in "
                                               "ball:3 or vee:6:60), " +
                                               decimals(sizes_mm.least, 3) + " to " +
                                               decimals(sizes_mm.greatest, 0) + " mm across"};
    }
    tool.shape = *shape;
    return {};
}

Result<void> read_flute(const std::optional<double>& flute_mm, ToolProfile& tool) {
    if (!flute_mm) return {};
    if (tool.shape == ToolShape::point) {
        return Error{ErrorCode::bad_usage,
                     "--flute is of a tool that has a size, and this one is a point: --tool says which"};
    }
    const ProfileBounds lengths_mm = profile_bounds("tool.flute_mm");
    if (!lengths_mm.hold(*flute_mm)) {
        return Error{ErrorCode::bad_usage, "--flute must be " + decimals(lengths_mm.least, 0) + " to " +
                                               decimals(lengths_mm.greatest, 0) + " mm"};
    }
    tool.flute_mm = *flute_mm;
    return {};
}

Result<void> read_blank(const std::string& text, BlankProfile& blank) {
    if (text.empty()) return {};
    const auto parts = split(text, 'x');
    if (parts.size() != 2 || !parse_number(parts[0], blank.radius_mm) ||
        !parse_number(parts[1], blank.height_mm) || !(blank.radius_mm > 0.0) || !(blank.height_mm > 0.0)) {
        return Error{ErrorCode::bad_usage,
                     "--blank: '" + text + "' is not RADIUSxHEIGHT in mm (as in 30x60)"};
    }
    return {};
}

Result<void> read_blank_at(const std::string& text, BlankProfile& blank) {
    if (text.empty()) return {};
    const auto parts = split(text, ',');
    if (parts.size() != 2 || !parse_number(parts[0], blank.offset_x_mm) ||
        !parse_number(parts[1], blank.offset_z_mm)) {
        return Error{ErrorCode::bad_usage, "--blank-at: '" + text + "' is not X,Z in mm (as in 1.5,-2)"};
    }
    if (std::hypot(blank.offset_x_mm, blank.offset_z_mm) < blank.radius_mm) return {};
    return Error{ErrorCode::bad_usage,
                 "--blank-at: the table's axis would be outside the blank; --blank says how large that is"};
}

Result<void> read_depth_limit(const std::optional<double>& limit_mm, BlankProfile& blank) {
    if (!limit_mm) return {};
    blank.depth_limit_mm = *limit_mm;
    if (!(*limit_mm > 0.0) || !std::isfinite(*limit_mm))
        return Error{ErrorCode::bad_usage, "--depth-limit must be more than 0 mm"};
    if (blank.radius_mm > 0.0) return {};
    return Error{ErrorCode::bad_usage,
                 "--depth-limit is counted from the blank's surface: --blank says where that is"};
}

}  // namespace psicarve::cli
