// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/problem.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace psicarve::gcode {
namespace {

struct CodeRow {
    ProblemCode code;
    std::string_view name;
    const char* remedy;
};

using enum ProblemCode;
constexpr std::array<CodeRow, kProblemCodeCount> kCodeRows{{
    {line_too_long, "line_too_long", PSICARVE_TEXT("split the block: a line has 1024 bytes at most")},
    {bad_character, "bad_character", PSICARVE_TEXT("a block holds words, comments, / and %")},
    {open_comment, "open_comment", PSICARVE_TEXT("end the comment with ) on its line")},
    {nested_comment, "nested_comment", PSICARVE_TEXT("take the inner ( away")},
    {number_missing, "number_missing", PSICARVE_TEXT("write a number behind the letter")},
    {bad_number, "bad_number", PSICARVE_TEXT("write it with fewer digits")},
    {word_repeated, "word_repeated", PSICARVE_TEXT("give the letter once in a block")},
    {not_whole, "not_whole", PSICARVE_TEXT("write a whole number")},
    {out_of_range, "out_of_range", PSICARVE_TEXT("give a value that the word can have")},
    {not_read, "not_read", PSICARVE_TEXT("let the CAM system write it out in plain words")},
    {unknown_g, "unknown_g", PSICARVE_TEXT("use one of the G codes of docs/gcode.md")},
    {unknown_m, "unknown_m", PSICARVE_TEXT("use one of the M codes of docs/gcode.md")},
    {group_conflict, "group_conflict", PSICARVE_TEXT("give one code of a modal group in a block")},
    {claimed_twice, "claimed_twice", PSICARVE_TEXT("put one of the two into a block of its own")},
    {axes_missing, "axes_missing", PSICARVE_TEXT("say with an axis word what is to be done")},
    {axes_unused, "axes_unused", PSICARVE_TEXT("give G0, G1, G2 or G3 first")},
    {word_unused, "word_unused", PSICARVE_TEXT("take the word away, or add the code that it is for")},
    {word_missing, "word_missing", PSICARVE_TEXT("add the word")},
    {feed_missing, "feed_missing", PSICARVE_TEXT("give F before the first move that cuts")},
    {inverse_feed_missing, "inverse_feed_missing",
     PSICARVE_TEXT("give F in every such block while G93 holds")},
    {no_spindle_speed, "no_spindle_speed", PSICARVE_TEXT("give S first, or use G94")},
    {arc_centre_missing, "arc_centre_missing",
     PSICARVE_TEXT("give the centre with two of I, J and K, or the radius with R")},
    {arc_radius_differs, "arc_radius_differs", PSICARVE_TEXT("give centre and end with more digits")},
    {arc_radius_zero, "arc_radius_zero", PSICARVE_TEXT("set the centre off the arc")},
    {arc_radius_small, "arc_radius_small", PSICARVE_TEXT("give R half the way to the end at least")},
    {arc_whole_by_radius, "arc_whole_by_radius",
     PSICARVE_TEXT("give the centre: R does not tell where a whole circle lies")},
    {arc_words_mixed, "arc_words_mixed",
     PSICARVE_TEXT("give the centre in the plane's two words, or R alone")},
    {arc_rotated, "arc_rotated", PSICARVE_TEXT("use G17, or take the rotation away with G10 L2 R0")},
    {drawing_beside, "drawing_beside",
     PSICARVE_TEXT("give G7.1 with its C, G12.1 and G13.1 a block of their own")},
    {drawing_begin, "drawing_begin",
     PSICARVE_TEXT("bring X and C to known places first, with X 0 on the axis, no rotation and both tips of "
                   "one X alike")},
    {drawing_code, "drawing_code", PSICARVE_TEXT("end the mode first, with G7.1 C0 or G13.1")},
    {cycle_depth, "cycle_depth", PSICARVE_TEXT("set R above the depth of the hole")},
    {cycle_feed_mode, "cycle_feed_mode", PSICARVE_TEXT("use G94 for cycles")},
    {cycle_rotary, "cycle_rotary", PSICARVE_TEXT("turn the axis in a block before the cycle")},
    {g53_motion, "g53_motion", PSICARVE_TEXT("use G53 in a block with G0 or G1")},
    {g53_incremental, "g53_incremental", PSICARVE_TEXT("use G53 under G90")},
    {compensation, "compensation", PSICARVE_TEXT("let the CAM system compensate: a radial tool has no side")},
    {tool_table, "tool_table", PSICARVE_TEXT("give the length itself with G43.1")},
    {percent_place, "percent_place",
     PSICARVE_TEXT("put % on a line of its own, as the first and the last one")},
    {no_end, "no_end", PSICARVE_TEXT("end the program with M2 or M30, or frame it with two lines of %")},
    {axis_missing, "axis_missing",
     PSICARVE_TEXT("use the letters that [gcode] in the profile gives to the axes")},
    {arc_axes, "arc_axes",
     PSICARVE_TEXT("draw arcs in Y and one head: G17 or G19, with the letters of lathes G18")},
    {outside_travel, "outside_travel", PSICARVE_TEXT("move the work offset, or the part")},
    {core_radius, "core_radius", PSICARVE_TEXT("keep the tip further out")},
    {heads_meet, "heads_meet", PSICARVE_TEXT("keep the two tips further apart")},
    {spindle_reverse, "spindle_reverse", PSICARVE_TEXT("use M3: the spindle is only switched")},
    {output_missing, "output_missing", PSICARVE_TEXT("take it out: nothing is wired there")},
    {override_kept, "override_kept", PSICARVE_TEXT("take it out: the operator's overrides always hold")},
    {bracket_missing, "bracket_missing", PSICARVE_TEXT("close every [ with ], and every < of a name with >")},
    {expression_wrong, "expression_wrong", PSICARVE_TEXT("use the operators and functions of docs/gcode.md")},
    {value_impossible, "value_impossible", PSICARVE_TEXT("give it a value that can be calculated")},
    {parameter_range, "parameter_range", PSICARVE_TEXT("use the parameters #1 to #5601")},
    {parameter_unset, "parameter_unset", PSICARVE_TEXT("set the parameter before it is used")},
    {parameter_kept, "parameter_kept",
     PSICARVE_TEXT("leave the parameter as it is: only the machine sets it")},
    {parameter_many, "parameter_many", PSICARVE_TEXT("use fewer names")},
    {assignment_wrong, "assignment_wrong", PSICARVE_TEXT("write #number=value or #<name>=value")},
    {too_deep, "too_deep", PSICARVE_TEXT("use fewer levels: 64 of brackets, 100 of O words, 100 of calls")},
    {o_word_wrong, "o_word_wrong", PSICARVE_TEXT("use an O word as docs/gcode.md has them")},
    {o_word_beside, "o_word_beside", PSICARVE_TEXT("give an O word a line of its own")},
    {o_word_unmatched, "o_word_unmatched",
     PSICARVE_TEXT("begin and end with one number or name, one block within the other")},
    {o_word_open, "o_word_open", PSICARVE_TEXT("end the block before the program ends")},
    {o_word_place, "o_word_place", PSICARVE_TEXT("put it where docs/gcode.md allows it")},
    {sub_missing, "sub_missing", PSICARVE_TEXT("write the subroutine into the same file")},
    {sub_twice, "sub_twice", PSICARVE_TEXT("give each subroutine its own number or name")},
    {too_many_arguments, "too_many_arguments", PSICARVE_TEXT("pass 30 values at most")},
    {endless, "endless", PSICARVE_TEXT("let the loop end, or move in it")},
    {too_many_blocks, "too_many_blocks",
     PSICARVE_TEXT("let the CAM system write the blocks out, or take fewer passes")},
    {text_too_long, "text_too_long",
     PSICARVE_TEXT("store the program in a file: there it may be of any length")},
    {feed_beside_units, "feed_beside_units", PSICARVE_TEXT("put the units into a block before the feed")},
    {speed_unused, "speed_unused", PSICARVE_TEXT("set the speed at the spindle")},
    {coolant_unused, "coolant_unused", PSICARVE_TEXT("switch coolant by hand")},
    {tolerance_unused, "tolerance_unused", PSICARVE_TEXT("say with P how near corners are passed")},
    {not_stepped, "not_stepped", PSICARVE_TEXT("docs/gcode.md says which ways run step by step")},
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

const char* remedy_of(ProblemCode code) noexcept {
    return row_of(code).remedy;
}

bool is_warning(ProblemCode code) noexcept {
    return code >= feed_beside_units;
}

Phrase what_phrase(const Problem& problem) {
    if (problem.times <= 1) return problem.what;
    return {PSICARVE_TEXT("%2 (%1 times, here first)"), {std::to_string(problem.times)}, {problem.what}};
}

Phrase problem_phrase(const Problem& problem) {
    return {PSICARVE_TEXT("%1: %2; %3"),
            {std::string{name_of(problem.code)}},
            {what_phrase(problem), phrase(remedy_of(problem.code))}};
}

std::string what_text(const Problem& problem) {
    return session::as_told(problem.what);
}

std::string problem_text(const Problem& problem, std::string_view file_name) {
    std::string text{file_name};
    text += ':' + std::to_string(problem.line) + ':' + std::to_string(problem.column) + ": ";
    return text + session::as_told(problem_phrase(problem));
}

std::string mm_text(double length_mm) {
    return number_as("%.4f", length_mm);
}

std::string number_as(const char* format, double value) {
    char text[330];  // a double has 309 digits before its point
    std::snprintf(text, sizeof text, format, value);
    return text;
}

void ProblemList::count(std::uint64_t line, std::uint32_t column, ProblemCode code, const char* kind) {
    for (Problem& told : warnings_) {
        if (told.code != code || std::string_view{told.what.english} != kind) continue;
        ++told.times;
        return;
    }
    ++warning_count_;
    // However many others there are.
    warnings_.push_back({line, column, code, phrase(kind)});
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
