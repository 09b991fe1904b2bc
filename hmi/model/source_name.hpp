// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace psicarve::model {

/// Where an open descriptor is read by name, as what came by standard input is.
inline constexpr std::string_view kDescriptorFolder = "/proc/self/fd/";

/// What a job says it was made from: the file's name without its folder, or "standard input".
inline std::string source_name_of(const std::string& path) {
    if (path.starts_with(kDescriptorFolder)) return "standard input";
    return std::filesystem::path(path).filename().string();
}

}  // namespace psicarve::model
