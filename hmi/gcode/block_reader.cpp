// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/block_reader.hpp"

#include <cstddef>
#include <string>

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

/// The reader of one line.
class LineReader {
public:
    LineReader(std::string_view line, std::uint64_t line_number, Block& block) noexcept
        : line_(line), line_number_(line_number), block_(block) {}

    std::optional<Problem> read() {
        block_.begin(line_number_);
        skip_blanks();
        if (at_ < line_.size() && line_[at_] == '/') {
            block_.mark_deleted();
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
    Problem problem(std::size_t index, ProblemCode code, std::string what) const {
        return {line_number_, static_cast<std::uint32_t>(index + 1), code, std::move(what)};
    }

    void skip_blanks() noexcept {
        while (at_ < line_.size() && is_blank(line_[at_])) ++at_;
    }

    std::optional<Problem> pass_comment() {
        const std::size_t end = line_.find_first_of("()", at_ + 1);
        if (end == std::string_view::npos)
            return problem(at_, ProblemCode::open_comment, "the comment has no end");
        if (line_[end] == '(')
            return problem(end, ProblemCode::nested_comment, "a comment begins within a comment");
        at_ = end + 1;
        return std::nullopt;
    }

    std::optional<Problem> read_word(char letter) {
        if (!is_word_letter(letter)) return refuse_character(letter);
        const NumberReading number = read_number(line_, at_ + 1);
        if (!number.has_digits) return refuse_number(letter, number.end);
        const std::string_view text = line_.substr(at_, number.end - at_);
        if (!number.value)
            return problem(at_, ProblemCode::bad_number,
                           "'" + std::string{text.substr(0, 24)} + "...' is more than 1000000000");
        block_.add({letter, static_cast<std::uint32_t>(at_ + 1), *number.value});
        at_ = number.end;
        return std::nullopt;
    }

    Problem refuse_character(char letter) const {
        if (letter == '#' || letter == '[')
            return problem(at_, ProblemCode::not_read, "parameters and expressions are not read");
        if (letter == 'O')
            return problem(at_, ProblemCode::not_read, "O words and program numbers are not read");
        if (letter == '%')
            return problem(at_, ProblemCode::percent_place, "% stands among other things, or in the middle");
        return problem(at_, ProblemCode::bad_character, "'" + std::string{line_[at_]} + "' begins no word");
    }

    Problem refuse_number(char letter, std::size_t end) const {
        if (end < line_.size() && (line_[end] == '#' || line_[end] == '['))
            return problem(end, ProblemCode::not_read, "parameters and expressions are not read");
        return problem(at_, ProblemCode::number_missing, std::string{letter} + " has no number");
    }

    std::string_view line_;
    std::uint64_t line_number_;
    Block& block_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<Problem> read_block(std::string_view line, std::uint64_t line_number, Block& block) {
    if (line.size() > kMostLineBytes) {
        block.begin(line_number);
        return Problem{line_number, static_cast<std::uint32_t>(kMostLineBytes + 1),
                       ProblemCode::line_too_long, "the line has more than 1024 bytes"};
    }
    return LineReader{line, line_number, block}.read();
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
