// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/block_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "hmi/gcode/expression_reader.hpp"
#include "hmi/gcode/number_reader.hpp"

namespace psicarve::gcode {
namespace {

bool is_blank(char byte) noexcept {
    return byte == ' ' || byte == '\t' || byte == '\r';
}

char capital(char byte) noexcept {
    return byte >= 'a' && byte <= 'z' ? static_cast<char>(byte - 'a' + 'A') : byte;
}

bool is_word_letter(char letter) noexcept {
    return letter >= 'A' && letter <= 'Z' && letter != 'E' && letter != 'O';
}

constexpr double kLargestValue = 1e9;

/// A calculated value where the word counts something: what is nearly whole is meant to be.
/// Source: LinuxCNC 2.9: codes within 0.0001, whole numbers, too.
double counted(char letter, double value) noexcept {
    double tolerance = 0.0;
    if (letter == 'G' || std::string_view{"DHLMNT"}.find(letter) != std::string_view::npos)
        tolerance = 1.00001e-4;
    if (letter == 'P') tolerance = 1e-9;
    const double nearest = letter == 'G' ? std::round(value * 10.0) / 10.0 : std::round(value);
    return std::abs(value - nearest) <= tolerance ? nearest : value;
}

/// Two letters behind a letter begin a function; one is the next word.
bool begins_value(std::string_view line, std::size_t at) noexcept {
    if (std::string_view{"#[+-"}.find(line[at]) != std::string_view::npos) return true;
    std::size_t next = at + 1;
    while (next < line.size() && is_blank(line[next])) ++next;
    const auto is_letter = [](char byte) { return capital(byte) >= 'A' && capital(byte) <= 'Z'; };
    return is_letter(line[at]) && next < line.size() && is_letter(line[next]);
}

/// The reader of one line.
class LineReader {
public:
    LineReader(std::string_view line, std::uint64_t line_number, Parameters& parameters, ReadingMode mode,
               Block& block) noexcept
        : line_(line), line_number_(line_number), parameters_(parameters), mode_(mode), block_(block) {}

    std::optional<Problem> read() {
        block_.begin(line_number_);
        skip_blanks();
        if (at_ < line_.size() && line_[at_] == '/') {
            block_.mark_deleted();
            if (mode_.skips_deleted) return std::nullopt;
            ++at_;
        }
        for (skip_blanks(); at_ < line_.size(); skip_blanks()) {
            const char byte = line_[at_];
            if (byte == ';') return std::nullopt;
            auto problem = byte == '(' ? pass_comment() : read_word(capital(byte));
            if (problem) return problem;
        }
        return std::nullopt;
    }

private:
    Problem problem(std::size_t index, ProblemCode code, Phrase what) const {
        return {line_number_, static_cast<std::uint32_t>(index + 1), code, std::move(what)};
    }

    void skip_blanks() noexcept {
        while (at_ < line_.size() && is_blank(line_[at_])) ++at_;
    }

    std::optional<Problem> pass_comment() {
        const std::size_t end = line_.find_first_of("()", at_ + 1);
        if (end == std::string_view::npos)
            return problem(at_, ProblemCode::open_comment, phrase("the comment has no end"));
        if (line_[end] == '(')
            return problem(end, ProblemCode::nested_comment, phrase("a comment begins within a comment"));
        at_ = end + 1;
        return std::nullopt;
    }

    std::optional<Problem> read_word(char letter) {
        if (letter == '#') return read_assignment();
        if (letter == 'O') return find_o_word();
        if (!is_word_letter(letter)) return refuse_character(letter);
        const NumberReading number = read_number(line_, at_ + 1);
        if (!number.has_digits) return read_calculated(letter);
        const std::string_view text = line_.substr(at_, number.end - at_);
        if (!number.value)
            return problem(at_, ProblemCode::bad_number,
                           phrase("'%1...' is more than 1000000000", text.substr(0, 24)));
        block_.add({letter, static_cast<std::uint32_t>(at_ + 1), *number.value});
        at_ = number.end;
        return std::nullopt;
    }

    /// A word whose number is a parameter, an expression, or a function.
    std::optional<Problem> read_calculated(char letter) {
        ExpressionReader reader{line_, at_ + 1, parameters_, mode_.is_judging};
        if (reader.is_at_end() || !begins_value(line_, reader.at()))
            return problem(at_, ProblemCode::number_missing, phrase("%1 has no number", letter));
        block_.mark_values();
        double value = 0.0;
        if (!reader.read_value(value)) return of(reader);
        if (std::abs(value) > kLargestValue)
            return problem(at_, ProblemCode::bad_number,
                           phrase("%1 has a value of more than 1000000000", letter));
        block_.add({letter, static_cast<std::uint32_t>(at_ + 1), counted(letter, value)});
        at_ = reader.at();
        return std::nullopt;
    }

    std::optional<Problem> read_assignment() {
        const std::size_t begin = at_;
        block_.mark_values();
        ExpressionReader reader{line_, at_ + 1, parameters_, mode_.is_judging};
        ParameterKey key;
        if (!reader.read_key(key)) return of(reader);
        if (!reader.take("="))
            return problem(begin, ProblemCode::assignment_wrong,
                           phrase("a parameter stands here, and sets nothing"));
        double value = 0.0;
        if (!reader.read_value(value)) return of(reader);
        if (!mode_.is_judging) {
            if (auto wrong = parameters_.judge_write(key))
                return problem(begin, wrong->code, std::move(wrong->what));
            parameters_.plan(key, value);
        }
        at_ = reader.at();
        return std::nullopt;
    }

    /// It stands at the begin of its line, or behind the line's number.
    std::optional<Problem> find_o_word() {
        const auto words = block_.words();
        const bool is_first =
            std::all_of(words.begin(), words.end(), [](const Word& word) { return word.letter == 'N'; });
        if (!is_first)
            return problem(at_, ProblemCode::o_word_beside, phrase("an O word stands behind other words"));
        block_.mark_o_word(at_);
        at_ = line_.size();
        return std::nullopt;
    }

    Problem of(const ExpressionReader& reader) const {
        const LineFault& fault = reader.fault();
        return problem(fault.index, fault.code, fault.what);
    }

    Problem refuse_character(char letter) const {
        if (letter == '[')
            return problem(at_, ProblemCode::bad_character,
                           phrase("an expression stands here without a letter"));
        if (letter == '%')
            return problem(at_, ProblemCode::percent_place,
                           phrase("% stands among other things, or in the middle"));
        return problem(at_, ProblemCode::bad_character, phrase("'%1' begins no word", line_[at_]));
    }

    std::string_view line_;
    std::uint64_t line_number_;
    Parameters& parameters_;
    ReadingMode mode_;
    Block& block_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<Problem> read_block(std::string_view line, std::uint64_t line_number, Parameters& parameters,
                                  ReadingMode mode, Block& block) {
    if (line.size() > kMostLineBytes) {
        block.begin(line_number);
        return Problem{line_number, static_cast<std::uint32_t>(kMostLineBytes + 1),
                       ProblemCode::line_too_long, phrase("the line has more than 1024 bytes")};
    }
    return LineReader{line, line_number, parameters, mode, block}.read();
}

bool is_percent_line(std::string_view line) noexcept {
    bool has_percent = false;
    for (const char byte : line) {
        if (is_blank(byte)) continue;
        if (byte != '%' || has_percent) return false;
        has_percent = true;
    }
    return has_percent;
}

}  // namespace psicarve::gcode
