// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hmi/gcode/line_source.hpp"
#include "shared/base/result.hpp"

namespace psicarve::program {

/// Where the lines of a text begin, in constant memory: of every line while they are few, of every second,
/// fourth ... when they are many.
class LineIndex {
public:
    static constexpr std::size_t kMostMarks = 65'536;

    /// A line whose place is known.
    struct Mark {
        std::uint64_t line = 1;  ///< from 1
        std::uint64_t offset_bytes = 0;
    };

    /// The next bytes of the text.
    void note(std::span<const char> bytes);
    /// What stands behind the last line feed is a line, too, if it is not empty.
    std::uint64_t line_count() const noexcept;
    std::uint64_t byte_count() const noexcept { return bytes_; }
    /// The last one that is not behind the line.
    Mark before(std::uint64_t line) const noexcept;
    std::size_t mark_count() const noexcept { return marks_.size(); }

private:
    void mark(std::uint64_t offset_bytes);

    std::vector<std::uint64_t> marks_{0};  ///< of lines 1, 1 + stride_, 1 + 2 * stride_ ...
    std::uint64_t stride_ = 1;
    std::uint64_t ended_lines_ = 0;
    std::uint64_t bytes_ = 0;
    bool is_within_line_ = false;
};

/// So much of a line is shown.
inline constexpr std::size_t kMostShownBytes = 512;

/// The text of `count` lines from `first` on, fewer at the end; each cut to kMostShownBytes, without its line
/// end. An error when the file is no longer what it was.
Result<std::vector<std::string>> read_lines(const std::string& path, const gcode::FileState& state,
                                            const LineIndex& index, std::uint64_t first, std::uint64_t count);

}  // namespace psicarve::program
