// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "hmi/gcode/block.hpp"
#include "shared/base/result.hpp"

namespace psicarve::gcode {

/// Gives the next bytes of a program: returns how many were put into the room, 0 at the end.
using ByteSource = std::function<Result<std::size_t>(std::span<char> room)>;

/// A program line by line, in constant memory however long it is.
class LineSource {
public:
    explicit LineSource(ByteSource bytes);

    /// The next line without its line feed; valid until the next call. A line longer than kMostLineBytes is
    /// cut to a byte more than that. False: there is none.
    Result<bool> next(std::string_view& line);
    /// Number of the line that next() gave, from 1.
    std::uint64_t number() const noexcept { return number_; }

private:
    Result<bool> fill();

    ByteSource bytes_;
    std::string buffer_;
    std::string joined_;  ///< a line that lies in two fills
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    std::uint64_t number_ = 0;
};

/// Reads a file; errors name it.
Result<ByteSource> open_program(const std::string& path);

/// The text that a file had at a time.
struct FileState {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t bytes = 0;
    std::int64_t changed_ns = 0;
    bool operator==(const FileState&) const = default;
};
/// bad_input for what is no regular file: it could be read only once.
Result<FileState> state_of_program(const std::string& path);
/// The same, and an error as soon as the file is no longer what it was.
Result<ByteSource> open_unchanged_program(const std::string& path, const FileState& state);

}  // namespace psicarve::gcode
