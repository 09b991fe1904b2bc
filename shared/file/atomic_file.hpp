// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "shared/base/result.hpp"

namespace psicarve {

/// Who may read and write a new file, regardless of the umask and of the rights of the file that it replaces.
struct FileRights {
    mode_t mode;
    std::optional<gid_t> group;  ///< nothing: the group that new files get in that folder
};
inline constexpr mode_t kForEverybody = 0644;  ///< owner writes, all users read

/// Writes a temporary file beside it, then fsync, rename, fsync of the folder: the old file stays intact
/// whatever happens. Keeps an existing file's mode; a new one gets what the umask leaves. A symbolic link is
/// replaced, not followed; what is no regular file (a folder, a device, a pipe) is refused, and so is a name
/// of an open descriptor (/dev/stdout), whatever is open there.
Result<void> write_file_atomically(const std::string& path, std::span<const std::byte> bytes);
/// The same for bytes in several pieces.
Result<void> write_parts_atomically(const std::string& path,
                                    std::span<const std::span<const std::byte>> parts,
                                    const std::optional<FileRights>& rights = std::nullopt);
/// The same for content that is too large for memory: `put` writes it and need not check whether that worked.
Result<void> write_stream_atomically(const std::string& path, const std::function<void(std::FILE*)>& put);

/// Whether a file of this name could be written now: for programs that work for long before they write.
/// Changes nothing.
Result<void> check_writable(const std::string& path);

/// The whole of a regular file, in memory. Anything else (a pipe, a device) is refused, never waited for.
Result<std::vector<std::byte>> read_whole_file(const std::string& path);
/// Its first bytes: as many as it has, at most `most_bytes`.
Result<std::vector<std::byte>> read_file_start(const std::string& path, std::uint64_t most_bytes);

}  // namespace psicarve
