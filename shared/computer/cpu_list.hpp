// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace psicarve {

/// The kernel's way to write a set of processors: "0-2,5" is 0 1 2 5, in rising order, each once. An empty
/// text (or one of white space) is the empty set; nothing when it is something else.
std::optional<std::vector<int>> cpus_from_list(std::string_view text);

}  // namespace psicarve
