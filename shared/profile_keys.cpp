// SPDX-License-Identifier: GPL-3.0-or-later
#include <type_traits>
#include <utility>

#include "shared/profile_table.hpp"

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

}  // namespace psicarve
