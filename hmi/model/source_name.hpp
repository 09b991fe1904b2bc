// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace psicarve::model {

/// The folder in which an open descriptor can be read by name, as standard input is.
inline constexpr std::string_view kDescriptorFolder = "/proc/self/fd/";

/// The source's name in a job: the file's name without its folder, or "standard input".
inline std::string source_name_of(const std::string& path) {
    if (path.starts_with(kDescriptorFolder)) return "standard input";
    return std::filesystem::path(path).filename().string();
}

}  // namespace psicarve::model
