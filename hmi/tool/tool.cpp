// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/tool.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "shared/base/units.hpp"

namespace psicarve::tool {

std::string name_of(const ToolProfile& profile) {
    std::string name{psicarve::name_of(profile.shape)};
    if (profile.shape == ToolShape::point) return name;
    std::array<char, 64> size{};
    std::snprintf(size.data(), size.size(), " %g mm", profile.diameter_mm);
    name += size.data();
    if (profile.shape != ToolShape::vee) return name;
    std::snprintf(size.data(), size.size(), " %g deg", profile.angle_deg);
    return name + size.data();
}

Tool tool_of(const ToolProfile& profile, double per_mm) noexcept {
    return {profile.shape, 0.5 * profile.diameter_mm * per_mm, profile.angle_deg};
}

double flank_slope(const Tool& tool) noexcept {
    return tool.shape == Shape::vee ? 1.0 / std::tan(rad_from_deg(0.5 * tool.angle_deg)) : 0.0;
}

double half_width(const Tool& tool, double behind_tip) noexcept {
    if (tool.shape == Shape::point) return 0.0;
    if (tool.shape == Shape::flat) return tool.radius;
    if (tool.shape == Shape::vee) return std::min(tool.radius, behind_tip / flank_slope(tool));
    const double behind = std::min(behind_tip, tool.radius);
    return std::sqrt(behind * (2.0 * tool.radius - behind));
}

double rise(const Tool& tool, double s) noexcept {
    if (tool.shape == Shape::flat) return 0.0;
    if (tool.shape == Shape::vee) return s * flank_slope(tool);
    return tool.radius - std::sqrt(std::max(0.0, tool.radius * tool.radius - s * s));
}

}  // namespace psicarve::tool
