// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/gcode/parameters.hpp"
#include "hmi/gcode/problem.hpp"

namespace psicarve::gcode {

enum class OKeyword : std::uint8_t {
    label,  ///< a number or name alone: where M98 finds its subroutine
    sub,
    endsub,
    call,
    give_back,  ///< return
    if_so,
    else_if,
    else_so,
    endif,
    do_so,
    while_so,
    endwhile,
    repeat,
    endrepeat,
    break_off,
    go_on,  ///< continue
};
/// As it is written.
std::string_view name_of(OKeyword keyword) noexcept;

/// The begin of an O word's line.
struct OWord {
    std::string name;  ///< digits, or <name> in small letters; empty: calculated where values are not known
    OKeyword keyword = OKeyword::label;
    std::size_t begin = 0;      ///< index of the O
    std::size_t arguments = 0;  ///< index of what follows the keyword
};

/// Reads one line's O word in two steps, as it depends on the keyword whether its values are wanted.
class OWordReader {
public:
    OWordReader(std::string_view line, std::uint64_t line_number, Parameters& parameters) noexcept
        : line_(line), line_number_(line_number), parameters_(parameters) {}

    /// Name and keyword; `begin` is the index of the O.
    std::optional<Problem> read(std::size_t begin, bool is_judging, OWord& word);
    /// As many values in brackets as the keyword may have, and nothing but comments behind them.
    std::optional<Problem> read_arguments(const OWord& word, bool is_judging, std::vector<double>& values);

    Problem problem(std::size_t index, ProblemCode code, Phrase what) const;

private:
    std::string_view line_;
    std::uint64_t line_number_;
    Parameters& parameters_;
};

}  // namespace psicarve::gcode
