// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace psicarve {

/// How many letters must be put in, left out, changed or swapped with their neighbour to make `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that a typing mistake most likely meant; nothing when none is near enough to be a mistake.
std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& candidates);

}  // namespace psicarve
