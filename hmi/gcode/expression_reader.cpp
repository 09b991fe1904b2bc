// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/expression_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/gcode/number_reader.hpp"

namespace psicarve::gcode {
namespace {

constexpr int kMostLevels = 64;
constexpr int kWeakest = 1;
/// Source: LinuxCNC 2.9: nearer than this values are equal, and a number is whole.
constexpr double kEqual = 0.0001;

bool is_blank_byte(char byte) noexcept {
    return byte == ' ' || byte == '\t' || byte == '\r';
}

char large(char byte) noexcept {
    return byte >= 'a' && byte <= 'z' ? static_cast<char>(byte - 'a' + 'A') : byte;
}

char small(char byte) noexcept {
    return byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : byte;
}

}  // namespace

bool ExpressionReader::fail(std::size_t index, ProblemCode code, Phrase what) {
    fault_ = LineFault{index, code, std::move(what)};
    return false;
}

void ExpressionReader::skip_blanks() noexcept {
    while (at_ < line_.size() && is_blank_byte(line_[at_])) ++at_;
}

bool ExpressionReader::take(std::string_view text) noexcept {
    std::size_t at = at_;
    for (const char byte : text) {
        while (at < line_.size() && is_blank_byte(line_[at])) ++at;
        if (at >= line_.size() || large(line_[at]) != byte) return false;
        ++at;
    }
    at_ = at;
    return true;
}

bool ExpressionReader::is_next(char byte) noexcept {
    skip_blanks();
    return at_ < line_.size() && line_[at_] == byte;
}

bool ExpressionReader::is_at_end() noexcept {
    skip_blanks();
    return at_ >= line_.size();
}

bool ExpressionReader::starts_number() noexcept {
    return !is_at_end() && std::string_view{"0123456789.+-"}.find(line_[at_]) != std::string_view::npos;
}

bool ExpressionReader::read_value(double& value) {
    if (is_at_end()) return fail(at_, ProblemCode::number_missing, phrase("a value is missing"));
    if (++depth_ > kMostLevels)
        return fail(at_, ProblemCode::too_deep, phrase("brackets and signs in 64 levels"));
    const char byte = large(line_[at_]);
    bool is_read = false;
    if (byte == '#') {
        is_read = read_parameter(value);
    } else if (byte == '[') {
        is_read = read_bracketed(value);
    } else if (byte >= 'A' && byte <= 'Z') {
        is_read = read_function(value);
    } else {
        is_read = read_plain(value);
    }
    --depth_;
    return is_read;
}

/// A number, or a sign before anything else.
bool ExpressionReader::read_plain(double& value) {
    const std::size_t begin = at_;
    const NumberReading number = read_number(line_, at_);
    if (number.has_digits) {
        at_ = number.end;
        if (!number.value)
            return fail(begin, ProblemCode::bad_number, phrase("a number of more than 1000000000"));
        value = *number.value;
        return true;
    }
    if (line_[at_] != '-' && line_[at_] != '+')
        return fail(at_, ProblemCode::number_missing, phrase("a value is missing"));
    const bool is_negative = line_[at_++] == '-';
    if (!read_value(value)) return false;
    if (is_negative) value = -value;
    return true;
}

bool ExpressionReader::read_bracketed(double& value) {
    const std::size_t begin = at_;
    if (!take("[")) return fail(at_, ProblemCode::bracket_missing, phrase("[ is missing"));
    if (!read_operations(kWeakest, value)) return false;
    if (take("]")) return keep_finite(begin, value);
    if (is_at_end()) return fail(begin, ProblemCode::bracket_missing, phrase("[ has no ]"));
    return fail(at_, ProblemCode::expression_wrong, phrase("'%1' is neither an operator nor ]", line_[at_]));
}

bool ExpressionReader::read_name(std::string& name) {
    const std::size_t begin = at_;
    name.clear();
    if (!take("<")) return fail(at_, ProblemCode::bracket_missing, phrase("< is missing"));
    while (at_ < line_.size() && line_[at_] != '>') {
        if (!is_blank_byte(line_[at_])) name += small(line_[at_]);
        ++at_;
    }
    if (at_ >= line_.size()) return fail(begin, ProblemCode::bracket_missing, phrase("< has no >"));
    ++at_;
    return !name.empty() || fail(begin, ProblemCode::parameter_range, phrase("a name without letters"));
}

bool ExpressionReader::read_key(ParameterKey& key) {
    const std::size_t begin = at_;
    if (is_next('<')) return read_name(key.name);
    double number = 0.0;
    if (!read_value(number)) return false;
    if (is_judging_) number = std::min(std::max(number, 1.0), 1.0 * kLastParameter);
    const double nearest = std::round(number);
    if (!(std::abs(number - nearest) < kEqual) || nearest < 1.0 || nearest > kLastParameter)
        return fail(begin, ProblemCode::parameter_range, phrase("no parameter has this number"));
    key.name.clear();
    key.number = static_cast<std::uint32_t>(nearest);
    return true;
}

bool ExpressionReader::read_parameter(double& value) {
    const std::size_t begin = at_;
    ++at_;
    ParameterKey key;
    if (!read_key(key)) return false;
    value = 1.0;
    if (is_judging_) return true;
    auto wrong = parameters_.read(key, value);
    return !wrong || fail(begin, wrong->code, std::move(wrong->what));
}

bool ExpressionReader::keep_finite(std::size_t index, double value) {
    if (is_judging_ || std::isfinite(value)) return true;
    return fail(index, ProblemCode::value_impossible, phrase("the value is infinite, or none at all"));
}

}  // namespace psicarve::gcode
