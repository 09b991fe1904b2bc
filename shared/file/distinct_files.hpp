// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve {

/// A file as whoever gave it knows it.
struct NamedFile {
    std::string name;  ///< "--trace", "MODEL"
    std::string path;
    bool is_written = false;
};

/// Whether both names lead to one file, whatever they look like: device and inode where there is one, else
/// the folder and the last name. Never of what keeps nothing (/dev/null, a pipe, a folder), nor of "-".
bool is_same_file(const std::string& one, const std::string& other);

/// Refuses, as bad_usage, a file that is written and also read, or written twice; before any is opened, for
/// writing one would end the other. Names both.
Result<void> check_distinct(std::span<const NamedFile> files);

}  // namespace psicarve
