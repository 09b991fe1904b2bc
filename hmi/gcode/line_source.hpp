// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "hmi/gcode/block.hpp"
#include "hmi/gcode/kept_text.hpp"
#include "shared/base/result.hpp"

namespace psicarve::gcode {

/// Gives the next bytes of a program: returns how many were put into the room, 0 at the end.
using ByteSource = std::function<Result<std::size_t>(std::span<char> room)>;

/// Goes on reading from this byte of the program.
using ByteSeek = std::function<Result<void>(std::uint64_t offset)>;

struct ProgramBytes {
    ByteSource read;
    ByteSeek seek;  ///< empty: the bytes come once
};

/// A program line by line, in constant memory however long it is, and from a line on that was read before:
/// what cannot be read twice is kept as long as it is held, up to 64 MiB.
class LineSource {
public:
    explicit LineSource(ProgramBytes bytes);
    explicit LineSource(ByteSource bytes) : LineSource(ProgramBytes{std::move(bytes), {}}) {}

    /// The next line without its line feed; valid until the next call. A line longer than kMostLineBytes is
    /// cut to a byte more than that. False: there is none.
    Result<bool> next(std::string_view& line);
    /// Number of the line that next() gave, from 1.
    std::uint64_t number() const noexcept { return number_; }
    /// Whether that line had its line feed: the last one may have been torn off.
    bool has_line_feed() const noexcept { return has_line_feed_; }

    /// Of the line that next() gives next.
    LinePlace place() const noexcept { return {offset_, number_}; }
    /// next() goes on there. Requires can_go_to().
    Result<void> go_to(const LinePlace& place);
    bool can_go_to(const LinePlace& place) const noexcept;

    /// From here on go_to() is wanted, until as many release() as hold().
    void hold();
    void release();
    /// What has been held till now is wanted to the end.
    void keep_for_good();
    /// More had to be kept than there is room for.
    bool has_overflowed() const noexcept { return kept_.has_overflowed(); }

private:
    Result<bool> fill();
    Result<bool> next_of_bytes(std::string_view& line);

    ProgramBytes bytes_;
    std::string buffer_;
    std::string joined_;  ///< a line that lies in two fills
    bool has_line_feed_ = true;
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    std::uint64_t number_ = 0;
    std::uint64_t offset_ = 0;   ///< of the next line; in a stream counted by what next() has given
    std::uint64_t read_to_ = 0;  ///< of a stream: up to where it has been read
    KeptText kept_;
    std::size_t holds_ = 0;
};

/// Reads a file; errors name it.
Result<ProgramBytes> open_program(const std::string& path);

/// Reads what comes from a descriptor, from where it stands, and once. The caller may close its own.
Result<ProgramBytes> open_stream(int descriptor);

/// The text that a file had at a time.
struct FileState {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t bytes = 0;
    std::int64_t changed_ns = 0;         ///< the text
    std::int64_t status_changed_ns = 0;  ///< also where a program sets the time of the text back
    bool operator==(const FileState&) const = default;
};
/// bad_input for what is no regular file: it could be read only once.
Result<FileState> state_of_program(const std::string& path);
/// The same, and an error as soon as the file is no longer what it was.
Result<ProgramBytes> open_unchanged_program(const std::string& path, const FileState& state);

}  // namespace psicarve::gcode
