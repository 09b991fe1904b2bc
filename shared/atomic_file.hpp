// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "shared/result.hpp"

namespace psicarve {

/// Temporary file beside it, fsync, rename, fsync of the folder: the old file stays intact whatever happens.
/// Keeps an existing file's mode; a new one gets what the umask leaves. A symbolic link is replaced, not
/// followed; what is no regular file (a folder, a device, a pipe) is refused.
Result<void> write_file_atomically(const std::string& path, std::span<const std::byte> bytes);
/// The same for bytes that stand in several places.
Result<void> write_parts_atomically(const std::string& path,
                                    std::span<const std::span<const std::byte>> parts);

/// The whole of a regular file, in memory.
Result<std::vector<std::byte>> read_whole_file(const std::string& path);

}  // namespace psicarve
