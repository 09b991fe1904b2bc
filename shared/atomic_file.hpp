// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
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

/// The whole of a regular file, in memory. Anything else (a pipe, a device) is refused, never waited for.
Result<std::vector<std::byte>> read_whole_file(const std::string& path);
/// Its first bytes: as many as it has, at most `most_bytes`.
Result<std::vector<std::byte>> read_file_start(const std::string& path, std::uint64_t most_bytes);

}  // namespace psicarve
