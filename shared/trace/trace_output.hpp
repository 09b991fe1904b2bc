// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "shared/base/result.hpp"

namespace psicarve {

/// Where a pin trace goes, buffered: a file descriptor of our own, or a function that takes the bytes. A
/// failed write (disk full, reader gone) is kept as one error, after which everything is dropped: never a
/// signal, never a crash. A file that we made under a name is removed then: it would look like a whole trace,
/// and a full disk needs the room.
class TraceOutput {
public:
    /// `path` is a file, "-" for standard output or "fd:N" for a descriptor that is already open and becomes
    /// ours. An existing file is overwritten; a symbolic link, or a pipe without a reader, is refused.
    static Result<TraceOutput> open(const std::string& path);
    /// Called with the gathered bytes, at every flush.
    using Taker = std::function<void(std::span<const std::uint8_t> bytes)>;
    explicit TraceOutput(Taker taker);

    TraceOutput(TraceOutput&& other) noexcept;
    TraceOutput& operator=(TraceOutput&&) = delete;
    TraceOutput(const TraceOutput&) = delete;
    TraceOutput& operator=(const TraceOutput&) = delete;
    ~TraceOutput();  ///< writes out what is left

    /// Room for at least `bytes` (at most kLongestPiece), to be filled from its beginning; then commit().
    std::uint8_t* room(std::size_t bytes) noexcept {
        if (kBufferBytes - used_ < bytes) flush();
        return buffer_.get() + used_;
    }
    /// Everything before `end` in the last room() belongs to the file now.
    void commit(const std::uint8_t* end) noexcept { used_ = static_cast<std::size_t>(end - buffer_.get()); }
    void write(std::string_view text) noexcept;
    void flush() noexcept;
    /// Counts the bytes that were taken, also while a write waits; may be read on other threads, and outlives
    /// this.
    std::shared_ptr<const std::atomic<std::uint64_t>> written_bytes() const noexcept { return written_; }
    std::optional<Error> take_error();
    /// The trace will not be whole: a file that we made under a name is removed; nothing more is written.
    void discard() noexcept;

    static constexpr std::size_t kLongestPiece = 4096;

private:
    TraceOutput(int fd, std::string name);
    void remove_file() noexcept;
    void write_out(const std::uint8_t* bytes, std::size_t count) noexcept;

    static constexpr std::size_t kBufferBytes = std::size_t{256} * 1024;
    int fd_ = -1;
    Taker taker_;             ///< instead of a descriptor
    bool may_break_ = false;  ///< a pipe or socket: its reader can go away
    bool is_named_ = false;   ///< a regular file that we opened by its name
    bool is_removed_ = false;
    int failed_errno_ = 0;
    bool error_taken_ = false;
    std::string name_;
    std::unique_ptr<std::uint8_t[]> buffer_;
    std::size_t used_ = 0;
    std::shared_ptr<std::atomic<std::uint64_t>> written_ = std::make_shared<std::atomic<std::uint64_t>>(0);
};

}  // namespace psicarve
