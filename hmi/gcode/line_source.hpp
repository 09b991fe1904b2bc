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

}  // namespace psicarve::gcode
