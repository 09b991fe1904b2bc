// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::gcode {

using session::Phrase;
using session::phrase;

/// What can be wrong with a program. Names are stable; docs/gcode.md lists them.
enum class ProblemCode : std::uint8_t {
    line_too_long,
    bad_character,
    open_comment,
    nested_comment,
    number_missing,
    bad_number,
    word_repeated,
    not_whole,
    out_of_range,
    not_read,
    unknown_g,
    unknown_m,
    group_conflict,
    claimed_twice,
    axes_missing,
    axes_unused,
    word_unused,
    word_missing,
    feed_missing,
    inverse_feed_missing,
    no_spindle_speed,
    arc_centre_missing,
    arc_radius_differs,
    arc_radius_zero,
    arc_radius_small,
    arc_whole_by_radius,
    arc_words_mixed,
    arc_rotated,
    drawing_beside,
    drawing_begin,
    drawing_code,
    cycle_depth,
    cycle_feed_mode,
    cycle_rotary,
    g53_motion,
    g53_incremental,
    compensation,
    tool_table,
    percent_place,
    no_end,
    axis_missing,
    arc_axes,
    outside_travel,
    core_radius,
    heads_meet,
    spindle_reverse,
    output_missing,
    override_kept,
    bracket_missing,
    expression_wrong,
    value_impossible,
    parameter_range,
    parameter_unset,
    parameter_kept,
    parameter_many,
    assignment_wrong,
    too_deep,
    o_word_wrong,
    o_word_beside,
    o_word_unmatched,
    o_word_open,
    o_word_place,
    sub_missing,
    sub_twice,
    too_many_arguments,
    endless,
    too_many_blocks,
    text_too_long,
    feed_beside_units,
    speed_unused,
    coolant_unused,
    tolerance_unused,
    not_stepped,
};
inline constexpr std::size_t kProblemCodeCount = 73;

std::string_view name_of(ProblemCode code) noexcept;
/// What to do about it, one clause, which is translated where it is shown.
const char* remedy_of(ProblemCode code) noexcept;
/// The problem is reported, and the program is valid all the same.
bool is_warning(ProblemCode code) noexcept;

struct Problem {
    std::uint64_t line = 0;    ///< from 1
    std::uint32_t column = 0;  ///< from 1, in bytes
    ProblemCode code = ProblemCode::bad_character;
    Phrase what;
    std::uint64_t times = 1;  ///< so often there is the same; this is the first
};
/// What is wrong, and how often where it is told once.
Phrase what_phrase(const Problem& problem);
/// "code: what is wrong; remedy"
Phrase problem_phrase(const Problem& problem);
/// What is wrong, in English; with the file's own bytes, as below.
std::string what_text(const Problem& problem);
/// "FILE:LINE:COLUMN: code: what is wrong; remedy"
std::string problem_text(const Problem& problem, std::string_view file_name);

/// With four decimals and without the unit, as problems tell lengths: their words have the unit.
std::string mm_text(double length_mm);
/// By printf's format of one double.
std::string number_as(const char* format, double value);

/// All problems of a program are counted, the first ones of each kind kept. A warning that is kept is not
/// told again of the same place.
class ProblemList {
public:
    static constexpr std::size_t kMostKept = 100;

    void add(Problem problem);
    /// A warning of which there are few kinds: each is told once, where it came first, and how often.
    /// `kind` is a literal.
    void count(std::uint64_t line, std::uint32_t column, ProblemCode code, const char* kind);
    const std::vector<Problem>& errors() const noexcept { return errors_; }
    const std::vector<Problem>& warnings() const noexcept { return warnings_; }
    std::uint64_t error_count() const noexcept { return error_count_; }
    std::uint64_t warning_count() const noexcept { return warning_count_; }

private:
    std::vector<Problem> errors_;
    std::vector<Problem> warnings_;
    std::uint64_t error_count_ = 0;
    std::uint64_t warning_count_ = 0;
};

}  // namespace psicarve::gcode
