// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::model {

/// A regular file that is read, never mapped: when another program shortens it meanwhile, the result is a
/// short read and an error message, not a SIGBUS.
class InputFile {
public:
    static Result<InputFile> open(const std::string& path);
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&&) = delete;
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    ~InputFile();

    std::uint64_t size_bytes() const noexcept { return size_bytes_; }
    const std::string& path() const noexcept { return path_; }

    /// Fills `target` from `offset_bytes`; reading fewer bytes is an error.
    Result<void> read(std::uint64_t offset_bytes, std::span<char> target) const;
    Result<std::vector<char>> read_all() const;

private:
    InputFile(int descriptor, std::uint64_t size_bytes, std::string path)
        : descriptor_(descriptor), size_bytes_(size_bytes), path_(std::move(path)) {}

    int descriptor_ = -1;
    std::uint64_t size_bytes_ = 0;
    std::string path_;
};

}  // namespace psicarve::model
