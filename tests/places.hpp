// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// Where the tests find what they use. Only places.cpp knows it when it is compiled: whatever else is
/// compiled is the same in every folder, and a compiler's cache knows it again.
namespace psicarve {

/// A path below the project's root, as "docs/commands.md".
std::string in_source(std::string_view path);
/// A path below the folder of this build, as "bin/psicarve".
std::string in_build(std::string_view path);

inline std::string example(std::string_view name) {
    return in_source("examples/" + std::string{name});
}

}  // namespace psicarve
