// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/problem.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace psicarve::gcode {
namespace {

struct CodeRow {
    ProblemCode code;
    std::string_view name;
    std::string_view remedy;
};

using enum ProblemCode;
constexpr std::array<CodeRow, kProblemCodeCount> kCodeRows{{
    {line_too_long, "line_too_long", "split the block: a line has 1024 bytes at most"},
    {bad_character, "bad_character", "a block holds words, comments, / and %"},
    {open_comment, "open_comment", "end the comment with ) on its line"},
    {nested_comment, "nested_comment", "take the inner ( away"},
    {number_missing, "number_missing", "write a number behind the letter"},
    {bad_number, "bad_number", "write it with fewer digits"},
    {word_repeated, "word_repeated", "give the letter once in a block"},
    {not_whole, "not_whole", "write a whole number"},
    {out_of_range, "out_of_range", "give a value that the word can have"},
    {not_read, "not_read", "let the CAM system write it out in plain words"},
    {unknown_g, "unknown_g", "use one of the G codes of docs/gcode.md"},
    {unknown_m, "unknown_m", "use one of the M codes of docs/gcode.md"},
    {group_conflict, "group_conflict", "give one code of a modal group in a block"},
    {claimed_twice, "claimed_twice", "put one of the two into a block of its own"},
    {axes_missing, "axes_missing", "say with an axis word what is to be done"},
    {axes_unused, "axes_unused", "give G0, G1, G2 or G3 first"},
    {word_unused, "word_unused", "take the word away, or add the code that it is for"},
    {word_missing, "word_missing", "add the word"},
    {feed_missing, "feed_missing", "give F before the first move that cuts"},
    {inverse_feed_missing, "inverse_feed_missing", "give F in every such block while G93 holds"},
    {no_spindle_speed, "no_spindle_speed", "give S first, or use G94"},
    {arc_centre_missing, "arc_centre_missing",
     "give the centre with two of I, J and K, or the radius with R"},
    {arc_radius_differs, "arc_radius_differs", "give centre and end with more digits"},
    {arc_radius_zero, "arc_radius_zero", "set the centre off the arc"},
    {arc_radius_small, "arc_radius_small", "give R half the way to the end at least"},
    {arc_whole_by_radius, "arc_whole_by_radius",
     "give the centre: R does not tell where a whole circle lies"},
    {arc_words_mixed, "arc_words_mixed", "give the centre in the plane's two words, or R alone"},
    {arc_rotated, "arc_rotated", "use G17, or take the rotation away with G10 L2 R0"},
    {drawing_beside, "drawing_beside", "give G7.1 with its C, G12.1 and G13.1 a block of their own"},
    {drawing_begin, "drawing_begin",
     "bring X and C to known places first, with X 0 on the axis, no rotation and both tips of one X alike"},
    {drawing_code, "drawing_code", "end the mode first, with G7.1 C0 or G13.1"},
    {cycle_depth, "cycle_depth", "set R above the depth of the hole"},
    {cycle_feed_mode, "cycle_feed_mode", "use G94 for cycles"},
    {cycle_rotary, "cycle_rotary", "turn the axis in a block before the cycle"},
    {g53_motion, "g53_motion", "use G53 in a block with G0 or G1"},
    {g53_incremental, "g53_incremental", "use G53 under G90"},
    {compensation, "compensation", "let the CAM system compensate: a radial tool has no side"},
    {tool_table, "tool_table", "give the length itself with G43.1"},
    {percent_place, "percent_place", "put % on a line of its own, as the first and the last one"},
    {no_end, "no_end", "end the program with M2 or M30, or frame it with two lines of %"},
    {axis_missing, "axis_missing", "use the letters that [gcode] in the profile gives to the axes"},
    {arc_axes, "arc_axes", "draw arcs in Y and one head: G17 or G19, with the letters of lathes G18"},
    {outside_travel, "outside_travel", "move the work offset, or the part"},
    {core_radius, "core_radius", "keep the tip further out"},
    {heads_meet, "heads_meet", "keep the two tips further apart"},
    {spindle_reverse, "spindle_reverse", "use M3: the spindle is only switched"},
    {output_missing, "output_missing", "take it out: nothing is wired there"},
    {override_kept, "override_kept", "take it out: the operator's overrides always hold"},
    {bracket_missing, "bracket_missing", "close every [ with ], and every < of a name with >"},
    {expression_wrong, "expression_wrong", "use the operators and functions of docs/gcode.md"},
    {value_impossible, "value_impossible", "give it a value that can be calculated"},
    {parameter_range, "parameter_range", "use the parameters #1 to #5601"},
    {parameter_unset, "parameter_unset", "set the parameter before it is used"},
    {parameter_kept, "parameter_kept", "leave the parameter as it is: only the machine sets it"},
    {parameter_many, "parameter_many", "use fewer names"},
    {assignment_wrong, "assignment_wrong", "write #number=value or #<name>=value"},
    {too_deep, "too_deep", "use fewer levels: 64 of brackets, 100 of O words, 100 of calls"},
    {o_word_wrong, "o_word_wrong", "use an O word as docs/gcode.md has them"},
    {o_word_beside, "o_word_beside", "give an O word a line of its own"},
    {o_word_unmatched, "o_word_unmatched",
     "begin and end with one number or name, one block within the other"},
    {o_word_open, "o_word_open", "end the block before the program ends"},
    {o_word_place, "o_word_place", "put it where docs/gcode.md allows it"},
    {sub_missing, "sub_missing", "write the subroutine into the same file"},
    {sub_twice, "sub_twice", "give each subroutine its own number or name"},
    {too_many_arguments, "too_many_arguments", "pass 30 values at most"},
    {endless, "endless", "let the loop end, or move in it"},
    {too_many_blocks, "too_many_blocks", "let the CAM system write the blocks out, or take fewer passes"},
    {text_too_long, "text_too_long", "store the program in a file: there it may be of any length"},
    {feed_beside_units, "feed_beside_units", "put the units into a block before the feed"},
    {speed_unused, "speed_unused", "set the speed at the spindle"},
    {coolant_unused, "coolant_unused", "switch coolant by hand"},
    {tolerance_unused, "tolerance_unused", "say with P how near corners are passed"},
    {not_stepped, "not_stepped", "docs/gcode.md says which ways run step by step"},
}};

const CodeRow& row_of(ProblemCode code) noexcept {
    return kCodeRows[static_cast<std::size_t>(code)];
}

constexpr bool are_in_order() {
    for (std::size_t i = 0; i < kCodeRows.size(); ++i)
        if (static_cast<std::size_t>(kCodeRows[i].code) != i) return false;
    return true;
}
static_assert(are_in_order());

}  // namespace

std::string_view name_of(ProblemCode code) noexcept {
    return row_of(code).name;
}

std::string_view remedy_of(ProblemCode code) noexcept {
    return row_of(code).remedy;
}

bool is_warning(ProblemCode code) noexcept {
    return code >= feed_beside_units;
}

std::string what_text(const Problem& problem) {
    if (problem.times <= 1) return problem.what;
    return problem.what + " (" + std::to_string(problem.times) + " times, here first)";
}

std::string problem_text(const Problem& problem, std::string_view file_name) {
    std::string text{file_name};
    text += ':' + std::to_string(problem.line) + ':' + std::to_string(problem.column) + ": ";
    text += name_of(problem.code);
    text += ": " + what_text(problem) + "; ";
    text += remedy_of(problem.code);
    return text;
}

void ProblemList::count(std::uint64_t line, std::uint32_t column, ProblemCode code, std::string_view kind) {
    for (Problem& told : warnings_) {
        if (told.code != code || told.what != kind) continue;
        ++told.times;
        return;
    }
    ++warning_count_;
    // However many others there are.
    warnings_.push_back({line, column, code, std::string{kind}});
}

void ProblemList::add(Problem problem) {
    const bool warns = is_warning(problem.code);
    auto& kept = warns ? warnings_ : errors_;
    const auto is_told = [&](const Problem& told) {
        return told.line == problem.line && told.column == problem.column && told.code == problem.code;
    };
    // A loop comes by again.
    if (warns && std::any_of(kept.begin(), kept.end(), is_told)) return;
    ++(warns ? warning_count_ : error_count_);
    if (kept.size() < kMostKept) kept.push_back(std::move(problem));
}

}  // namespace psicarve::gcode
