// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::verify {

/// A file or pipe read through one buffer of fixed size. Owns the descriptor.
class ByteSource {
public:
    /// `offset`: the place in the file at which the descriptor stands.
    ByteSource(int descriptor, std::string name, std::uint64_t offset = 0);
    ~ByteSource();
    ByteSource(ByteSource&& other) noexcept;
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    ByteSource& operator=(ByteSource&&) = delete;

    /// Bytes that were read and not yet consumed. Valid until the next refill.
    std::string_view unread() const noexcept { return {buffer_.data() + begin_, end_ - begin_}; }
    void consume(std::size_t bytes) noexcept { begin_ += bytes; }

    /// Waits for more bytes behind the unread ones. False at the end of the file. bad_input when the unread
    /// bytes already fill the buffer: no valid record is that long.
    Result<bool> refill();
    /// Refills until `bytes` are unread or the file ends.
    Result<void> want(std::size_t bytes);

    bool at_end() const noexcept { return at_end_; }
    /// Place in the file of the first unread byte.
    std::uint64_t offset() const noexcept { return offset_of_buffer_ + begin_; }
    const std::string& name() const noexcept { return name_; }

    /// "NAME: byte N: text", N being `ahead` bytes past the first unread one.
    Error bad_at(std::size_t ahead, const std::string& text) const;

private:
    int descriptor_;
    std::string name_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    std::uint64_t offset_of_buffer_ = 0;
    bool at_end_ = false;
};

}  // namespace psicarve::verify
