// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace psicarve::profile {

/// Finds bytes of a UTF-8 text by line and column, both from 1, columns in code points, as toml++ counts
/// them: a byte order mark at the beginning does not count. Keeps a view of the text.
class TextPlaces {
public:
    explicit TextPlaces(std::string_view text);

    /// For a place beyond the text, its end.
    std::size_t offset_of(std::size_t line, std::size_t column) const;
    /// Where the line of this byte begins; and where the next line begins, or the text ends.
    std::size_t line_begin(std::size_t offset) const;
    std::size_t line_end(std::size_t offset) const;
    std::size_t text_begin() const noexcept { return begins_.front(); }
    /// "\r\n" where the first line ends so, else "\n".
    std::string_view newline() const;

private:
    std::string_view text_;
    std::vector<std::size_t> begins_;
};

}  // namespace psicarve::profile
