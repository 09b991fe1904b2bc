// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shared/profile/profile.hpp"

namespace psicarve::profile {

/// A key's value as an editor's field shows it: without quotes and brackets, "0.0 ... 60.0" for a range.
std::string typed_from_toml(const ProfileKey& key, std::string_view toml);

/// The typed text as TOML, or nothing: it is no value of this kind at all. Does not check bounds.
std::optional<std::string> toml_from_typed(const ProfileKey& key, std::string_view typed);

}  // namespace psicarve::profile
