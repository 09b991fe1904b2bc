// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "shared/profile/profile.hpp"

namespace psicarve::profile {

/// Index of a key in profile_keys().
inline std::size_t key_named(std::string_view path) {
    const auto& keys = profile_keys();
    const auto at =
        std::find_if(keys.begin(), keys.end(), [&](const ProfileKey& key) { return key.path == path; });
    EXPECT_NE(at, keys.end()) << path;
    return static_cast<std::size_t>(at - keys.begin());
}

}  // namespace psicarve::profile
