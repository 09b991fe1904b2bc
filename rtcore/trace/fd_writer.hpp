// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "shared/result.hpp"

namespace psicarve::trace {

/// Buffered writing to a file descriptor of our own. A failed write (disk full, reader gone) is kept as one
/// error, after which everything is dropped: never a signal, never a crash. A file that we made under a name
/// is removed then: a part that looks like a whole helps nobody, and a full disk needs the room.
class FdWriter {
public:
    /// As open_trace: a path, "-", "fd:N".
    static Result<FdWriter> open(const std::string& path);

    FdWriter(FdWriter&& other) noexcept;
    FdWriter& operator=(FdWriter&&) = delete;
    FdWriter(const FdWriter&) = delete;
    FdWriter& operator=(const FdWriter&) = delete;
    ~FdWriter();  ///< writes out what is left

    /// Room for at least `bytes` (at most kLongestPiece), to be filled from its beginning; then commit().
    std::uint8_t* room(std::size_t bytes) noexcept {
        if (kBufferBytes - used_ < bytes) flush();
        return buffer_.get() + used_;
    }
    /// Everything before `end` in the last room() belongs to the file now.
    void commit(const std::uint8_t* end) noexcept { used_ = static_cast<std::size_t>(end - buffer_.get()); }
    void write(std::string_view text) noexcept;
    void flush() noexcept;
    std::optional<Error> take_error();

    static constexpr std::size_t kLongestPiece = 4096;

private:
    FdWriter(int fd, std::string name);
    void remove_file() noexcept;
    void write_out(const std::uint8_t* bytes, std::size_t count) noexcept;

    static constexpr std::size_t kBufferBytes = std::size_t{256} * 1024;
    int fd_;
    bool may_break_;  ///< a pipe or socket: its reader can go away
    bool is_named_;   ///< a regular file that we opened by its name
    bool is_removed_ = false;
    int failed_errno_ = 0;
    bool error_taken_ = false;
    std::string name_;
    std::unique_ptr<std::uint8_t[]> buffer_;
    std::size_t used_ = 0;
};

}  // namespace psicarve::trace
