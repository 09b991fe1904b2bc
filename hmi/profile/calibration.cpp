// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/calibration.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::profile {
namespace {

// Values beyond these were measured or typed wrongly: no machine is built so.
constexpr double kLeastDiameter_mm = 0.5;
constexpr double kMostDiameter_mm = 1000.0;
constexpr double kMostTipOffset_mm = 20.0;
constexpr double kMostAngle_deg = 10.0;
constexpr double kMostHeight_mm = 20.0;
constexpr double kMostWear_mm = 5.0;

struct Setting {
    std::string key;
    double value;
};

std::string number(double value, int digits = 3) {
    char text[48];
    (void)std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

Result<void> check_diameter(const char* what, double diameter_mm) {
    if (diameter_mm >= kLeastDiameter_mm && diameter_mm <= kMostDiameter_mm) return {};
    return bad_input(std::string{what} + " of " + number(diameter_mm) + " mm is not possible; " +
                     number(kLeastDiameter_mm, 1) + " to " + number(kMostDiameter_mm, 0) + " mm");
}

std::size_t index_of_key(const std::string& path) {
    const auto& keys = profile_keys();
    std::size_t i = 0;
    while (i + 1 < keys.size() && keys[i].path != path) ++i;
    return i;
}

/// Sets all of them or none, and only if the whole profile stays valid.
Result<void> set(ProfileDraft& draft, std::initializer_list<Setting> settings) {
    ProfileDraft changed = draft;
    for (const Setting& setting : settings) {
        // As many digits as can be measured, and a zero without a sign.
        const double value = std::round(setting.value * 1e5) / 1e5 + 0.0;
        const std::size_t key = index_of_key(setting.key);
        if (std::strtod(changed.typed(key).c_str(), nullptr) != value) changed.type(key, number(value, 5));
    }
    if (const auto whole = changed.profile(); !whole) return whole.error();
    draft = std::move(changed);
    return {};
}

std::string axis_key(Axis head, const char* leaf) {
    return "axis." + std::string{name_of(head)} + "." + leaf;
}

}  // namespace

Result<void> touch_off(ProfileDraft& draft, Axis head, double pin_diameter_mm, double counted_mm) {
    if (auto ok = check_diameter("a pin", pin_diameter_mm); !ok) return ok;
    const std::string name{name_of(head)};
    const auto profile = draft.profile();
    if (!profile) return profile.error();
    const LinearAxisProfile& axis = head == Axis::r2 ? profile->r2 : profile->r1;
    if (counted_mm < axis.travel_mm[0] || counted_mm > axis.travel_mm[1]) {
        return bad_input(name + " cannot stand at " + number(counted_mm) + " mm; its travel is " +
                         number(axis.travel_mm[0]) + " to " + number(axis.travel_mm[1]) + " mm");
    }
    const double offset_mm = pin_diameter_mm / 2.0 - counted_mm;
    if (std::fabs(offset_mm) > kMostTipOffset_mm) {
        return bad_input("the tip of " + name + " would stand " + number(offset_mm) +
                         " mm further out than counted; is the pin's diameter " + number(pin_diameter_mm) +
                         " mm, and does the tip touch it at " + number(counted_mm) + " mm?");
    }
    return set(draft, {{axis_key(head, "tip_offset_mm"), offset_mm}, {axis_key(head, "tool_wear_mm"), 0.0}});
}

Result<void> two_marks(ProfileDraft& draft, double blank_diameter_mm, double around_mm, double up_mm) {
    if (auto ok = check_diameter("a blank", blank_diameter_mm); !ok) return ok;
    const double angle_deg = deg_from_rad(around_mm / (blank_diameter_mm / 2.0));
    if (!(std::fabs(angle_deg) <= kMostAngle_deg)) {
        return bad_input("marks " + number(around_mm) + " mm apart on a blank of " +
                         number(blank_diameter_mm) + " mm would be " + number(angle_deg, 1) +
                         " degrees; more than " + number(kMostAngle_deg, 0) +
                         " is no error of mounting. Was the table turned by exactly half a turn?");
    }
    if (!(std::fabs(up_mm) <= kMostHeight_mm)) {
        return bad_input("marks " + number(up_mm) + " mm apart in height; more than " +
                         number(kMostHeight_mm, 0) + " mm is no error of mounting. Was Y left alone?");
    }
    return set(draft, {{"head.r2.angle_error_deg", angle_deg}, {"head.r2.height_error_mm", up_mm}});
}

Result<void> tool_wear(ProfileDraft& draft, Axis head, double wear_mm) {
    if (!(wear_mm >= 0.0 && wear_mm <= kMostWear_mm)) {
        return bad_input("a tool does not become " + number(wear_mm) + " mm shorter; 0 to " +
                         number(kMostWear_mm, 0) + " mm, else touch the head off anew");
    }
    return set(draft, {{axis_key(head, "tool_wear_mm"), wear_mm}});
}

}  // namespace psicarve::profile
