// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// The first keys in which they differ, with both values: "axis.y.speed_mm_s: core 20.0, here 10.0"; after
/// `most` of them the number of further ones.
std::vector<Phrase> profile_differences(const Profile& core, const Profile& here, std::size_t most);

}  // namespace psicarve::session
