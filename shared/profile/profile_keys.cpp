// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>
#include <utility>

#include "shared/profile/profile_table.hpp"

namespace psicarve {
namespace detail = profile_detail;

namespace {

ProfileValue value_of(const detail::KeySpec& key) {
    static const Profile kAny;
    if (!key.words.empty()) return ProfileValue::word;
    const detail::Field field = detail::field_of(key, kAny);
    if (std::holds_alternative<std::string*>(field)) return ProfileValue::text;
    if (std::holds_alternative<std::array<double, 2>*>(field)) return ProfileValue::range;
    return std::holds_alternative<double*>(field) ? ProfileValue::number : ProfileValue::integer;
}

bool is_about_places(std::string_view path) {
    constexpr std::array<std::string_view, 6> kNames{"pulses_per_mm", "pulses_per_rev",  "tip_offset_mm",
                                                     "tool_wear_mm",  "angle_error_deg", "height_error_mm"};
    const std::string_view name = path.substr(path.rfind('.') + 1);
    return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

}  // namespace

const std::vector<ProfileKey>& profile_keys() {
    static const std::vector<ProfileKey> keys = [] {
        const Profile built_in;
        std::vector<ProfileKey> result;
        for (const detail::KeySpec& key : detail::key_table()) {
            std::vector<std::string> words;
            for (const detail::Word& word : key.words) words.emplace_back(word.text);
            result.push_back({key.path, key.unit, detail::bounds_text(key),
                              detail::value_as_toml(key, built_in), key.explanation, key.matters_to_motion,
                              value_of(key), std::move(words)});
        }
        return result;
    }();
    return keys;
}

ProfileBounds profile_bounds(std::string_view path) {
    const detail::Bounds& bounds = detail::find_key(path)->bounds;
    return {bounds.least, bounds.greatest};
}

std::vector<std::string> profile_values(const Profile& profile) {
    std::vector<std::string> values;
    values.reserve(detail::key_table().size());
    for (const detail::KeySpec& key : detail::key_table()) {
        values.push_back(detail::value_as_toml(key, profile));
    }
    return values;
}

std::vector<std::string> motion_differences(const Profile& a, const Profile& b) {
    std::vector<std::string> differing;
    for (const detail::KeySpec& key : detail::key_table()) {
        if (!key.matters_to_motion) continue;
        const bool same = std::visit(
            [](const auto* left, const auto* right) {
                if constexpr (std::is_same_v<decltype(left), decltype(right)>) {
                    return *left == *right;
                } else {
                    return false;
                }
            },
            detail::field_of(key, a), detail::field_of(key, b));
        if (!same) differing.push_back(key.path);
    }
    return differing;
}

std::vector<std::string> job_differences(const Profile& job, const Profile& machine) {
    std::vector<std::string> differing = motion_differences(job, machine);
    const bool is_unknown = job.blank.radius_mm == 0.0 && machine.blank.radius_mm > 0.0;
    if (is_unknown) differing.emplace_back("blank.radius_mm");
    return differing;
}

std::vector<std::string> place_differences(const Profile& a, const Profile& b) {
    std::vector<std::string> differing = motion_differences(a, b);
    std::erase_if(differing, [](const std::string& path) { return !is_about_places(path); });
    return differing;
}

}  // namespace psicarve
