// SPDX-License-Identifier: GPL-3.0-or-later
#include <type_traits>

#include "shared/profile_table.hpp"

namespace psicarve {
namespace detail = profile_detail;

const std::vector<ProfileKey>& profile_keys() {
    static const std::vector<ProfileKey> keys = [] {
        const Profile built_in;
        std::vector<ProfileKey> result;
        for (const detail::KeySpec& key : detail::key_table()) {
            result.push_back({key.path, key.unit, detail::bounds_text(key),
                              detail::value_as_toml(key, built_in), key.explanation, key.matters_to_motion});
        }
        return result;
    }();
    return keys;
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

}  // namespace psicarve
