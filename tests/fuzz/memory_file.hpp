// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "tests/fuzz/require.hpp"

namespace psicarve::fuzz {

/// A file that has no place in the file system but a path, with these bytes. Gone with the object.
class MemoryFile {
public:
    explicit MemoryFile(std::span<const std::uint8_t> bytes)
        : descriptor_(::memfd_create("fuzzed", MFD_CLOEXEC)) {
        require(descriptor_ >= 0, "the fuzzer gets a file");
        const auto written = ::pwrite(descriptor_, bytes.data(), bytes.size(), 0);
        require(written == static_cast<ssize_t>(bytes.size()), "the fuzzer's file takes the input");
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { ::close(descriptor_); }

    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
    /// Another descriptor, at the file's begin; the caller closes it.
    int opened() const { return ::open(path().c_str(), O_RDONLY | O_CLOEXEC); }

private:
    int descriptor_;
};

}  // namespace psicarve::fuzz
