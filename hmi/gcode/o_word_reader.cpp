// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/o_word_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hmi/gcode/expression_reader.hpp"

namespace psicarve::gcode {
namespace {

struct KeywordRow {
    OKeyword keyword;
    std::string_view text;
    std::size_t least_values;
    std::size_t most_values;
};

using enum OKeyword;
// A longer one stands before the one that it begins with.
constexpr std::array<KeywordRow, 15> kKeywordRows{{{sub, "SUB", 0, 0},
                                                   {endsub, "ENDSUB", 0, 1},
                                                   {call, "CALL", 0, kMostArguments},
                                                   {give_back, "RETURN", 0, 1},
                                                   {if_so, "IF", 1, 1},
                                                   {else_if, "ELSEIF", 1, 1},
                                                   {else_so, "ELSE", 0, 0},
                                                   {endif, "ENDIF", 0, 0},
                                                   {do_so, "DO", 0, 0},
                                                   {while_so, "WHILE", 1, 1},
                                                   {endwhile, "ENDWHILE", 0, 0},
                                                   {repeat, "REPEAT", 1, 1},
                                                   {endrepeat, "ENDREPEAT", 0, 0},
                                                   {break_off, "BREAK", 0, 0},
                                                   {go_on, "CONTINUE", 0, 0}}};
constexpr KeywordRow kLabelRow{label, "", 0, 0};
constexpr double kMostNumber = 1e9;

const KeywordRow& row_of_keyword(OKeyword keyword) noexcept {
    const auto found = std::find_if(kKeywordRows.begin(), kKeywordRows.end(),
                                    [=](const KeywordRow& row) { return row.keyword == keyword; });
    return found == kKeywordRows.end() ? kLabelRow : *found;
}

bool begins_comment(ExpressionReader& reader) noexcept {
    return reader.is_next('(') || reader.is_next(';');
}

}  // namespace

std::string_view name_of(OKeyword keyword) noexcept {
    static constexpr std::array<std::string_view, 16> kNames{
        "",      "sub", "endsub", "call",     "return", "if",        "elseif", "else",
        "endif", "do",  "while",  "endwhile", "repeat", "endrepeat", "break",  "continue"};
    return kNames[static_cast<std::size_t>(keyword)];
}

Problem OWordReader::problem(std::size_t index, ProblemCode code, Phrase what) const {
    return {line_number_, static_cast<std::uint32_t>(index + 1), code, std::move(what)};
}

std::optional<Problem> OWordReader::read(std::size_t begin, bool is_judging, OWord& word) {
    word.begin = begin;
    word.name.clear();
    ExpressionReader reader{line_, begin + 1, parameters_, is_judging};
    const auto refuse = [&] {
        return problem(reader.fault().index, reader.fault().code, reader.fault().what);
    };
    if (reader.is_next('<')) {
        if (!reader.read_name(word.name)) return refuse();
        word.name = "<" + word.name + ">";
    } else {
        const bool is_calculated = reader.is_next('[') || reader.is_next('#');
        double number = 0.0;
        if (!is_calculated && (reader.is_at_end() || !reader.starts_number()))
            return problem(begin, ProblemCode::o_word_wrong, phrase("O has neither a number nor a <name>"));
        if (!reader.read_value(number)) return refuse();
        const double nearest = std::round(number);
        if (!(std::abs(number - nearest) < 1e-4) || nearest < 0.0 || nearest > kMostNumber)
            return problem(begin, ProblemCode::o_word_wrong, phrase("the number of an O word is whole"));
        if (!is_calculated || !is_judging) word.name = std::to_string(static_cast<std::int64_t>(nearest));
    }
    word.keyword = label;
    if (!reader.is_at_end() && !begins_comment(reader)) {
        const KeywordRow* found = nullptr;
        std::size_t end = reader.at();
        for (const KeywordRow& row : kKeywordRows) {
            ExpressionReader ahead = reader;
            if (!ahead.take(row.text) || ahead.at() <= end) continue;
            found = &row;
            end = ahead.at();
        }
        if (found == nullptr)
            return problem(reader.at(), ProblemCode::o_word_wrong,
                           phrase("this is no word that can follow O"));
        word.keyword = found->keyword;
        reader.take(found->text);
    }
    word.arguments = reader.at();
    return std::nullopt;
}

std::optional<Problem> OWordReader::read_arguments(const OWord& word, bool is_judging,
                                                   std::vector<double>& values) {
    const KeywordRow& row = row_of_keyword(word.keyword);
    values.clear();
    ExpressionReader reader{line_, word.arguments, parameters_, is_judging};
    while (reader.is_next('[')) {
        const std::size_t begin = reader.at();
        double value = 0.0;
        if (!reader.read_bracketed(value))
            return problem(reader.fault().index, reader.fault().code, reader.fault().what);
        if (values.size() == row.most_values) {
            const bool is_call = word.keyword == call;
            return problem(begin, is_call ? ProblemCode::too_many_arguments : ProblemCode::o_word_beside,
                           phrase("%1 takes no more values", name_of(word.keyword)));
        }
        values.push_back(value);
    }
    if (values.size() < row.least_values)
        return problem(reader.at(), ProblemCode::bracket_missing,
                       phrase("%1 has no value in [ ]", name_of(word.keyword)));
    while (begins_comment(reader)) {
        const std::size_t at = reader.at();
        if (line_[at] == ';') return std::nullopt;
        const std::size_t end = line_.find_first_of("()", at + 1);
        if (end == std::string_view::npos)
            return problem(at, ProblemCode::open_comment, phrase("the comment has no end"));
        if (line_[end] == '(')
            return problem(end, ProblemCode::nested_comment, phrase("a comment begins within a comment"));
        reader.go_to(end + 1);
    }
    if (reader.is_at_end()) return std::nullopt;
    return problem(reader.at(), ProblemCode::o_word_beside, phrase("something stands behind the O word"));
}

}  // namespace psicarve::gcode
