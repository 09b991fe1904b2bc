// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve {

/// A file with the name that the user knows it by.
struct NamedFile {
    std::string name;  ///< "--trace", "MODEL"
    std::string path;
    bool is_written = false;
};

/// Whether both names lead to one file, whatever they look like: compares device and inode where there is a
/// file, else folder and last name. False for what keeps nothing (/dev/null, a pipe, a folder), and for "-".
bool is_same_file(const std::string& one, const std::string& other);

/// Refuses, as bad_usage, a file that is both written and read, or written twice. Call it before any is
/// opened: opening one for writing would empty the other. The message names both.
Result<void> check_distinct(std::span<const NamedFile> files);

}  // namespace psicarve
