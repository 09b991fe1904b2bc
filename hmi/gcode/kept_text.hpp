// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace psicarve::gcode {

/// Where a line begins.
struct LinePlace {
    std::uint64_t offset = 0;  ///< bytes from the program's begin
    std::uint64_t line = 0;    ///< how many lines lie before it
};

/// Lines of a stream that are read again: subroutines and loops, in bounded memory.
class KeptText {
public:
    static constexpr std::size_t kMostBytes = std::size_t{1} << 26U;

    void begin(std::uint64_t offset);
    /// A line that lies there, behind the last one.
    void append(std::uint64_t offset, std::string_view line);
    /// What is not kept for good is forgotten.
    void drop();
    void keep_for_good();

    bool holds(std::uint64_t offset) const noexcept { return piece_at(offset) != nullptr; }
    /// Requires holds(offset).
    std::string_view line_at(std::uint64_t offset) const noexcept;
    bool has_overflowed() const noexcept { return has_overflowed_; }

private:
    struct Piece {
        std::uint64_t offset = 0;
        std::size_t kept_bytes = 0;  ///< for good
        std::string text;            ///< each line with its line feed
    };
    const Piece* piece_at(std::uint64_t offset) const noexcept;

    std::vector<Piece> pieces_;  ///< by offset
    std::size_t bytes_ = 0;
    bool has_overflowed_ = false;
};

}  // namespace psicarve::gcode
