// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace psicarve {

/// Makes a text that may hold names of files and words of others safe for a terminal, a log or a window: what
/// would steer it (control characters but line feed and tab, DEL, C1, marks that turn the direction of
/// writing) becomes \u001b, which is valid within JSON, too; a byte that is no UTF-8 becomes \xff. All else
/// stays.
std::string printable(std::string_view text);

/// For text that comes in pieces: how many bytes at the end of `text` may be the begin of a letter.
std::size_t unfinished_letter_bytes(std::string_view text) noexcept;

}  // namespace psicarve
