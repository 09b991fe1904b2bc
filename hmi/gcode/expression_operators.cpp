// SPDX-License-Identifier: GPL-3.0-or-later
// Operators and functions of expressions.
#include <array>
#include <cmath>
#include <utility>

#include "hmi/gcode/expression_reader.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

/// Source: LinuxCNC 2.9: EQ and NE take values nearer than this for equal.
constexpr double kSameValue = 0.0001;

double truth(bool is_true) noexcept {
    return is_true ? 1.0 : 0.0;
}

}  // namespace

enum class ExpressionReader::Operator : std::uint8_t {
    power,
    product,
    quotient,
    modulo,
    sum,
    difference,
    eq,
    ne,
    gt,
    ge,
    lt,
    le,
    both,
    either,
    one,
};
enum class ExpressionReader::Function : std::uint8_t {
    abs,
    acos,
    asin,
    atan,
    cos,
    exists,
    exp,
    fix,
    fup,
    ln,
    round,
    sin,
    sqrt,
    tan,
};

struct ExpressionReader::OperatorEntry {
    std::string_view text;
    int strength;
    Operator operation;
};

namespace {
constexpr std::size_t kOperatorCount = 15;
}

// ** stands before *.
const ExpressionReader::OperatorEntry ExpressionReader::kOperators[] = {
    {"**", 5, Operator::power},   {"*", 4, Operator::product}, {"/", 4, Operator::quotient},
    {"MOD", 4, Operator::modulo}, {"+", 3, Operator::sum},     {"-", 3, Operator::difference},
    {"EQ", 2, Operator::eq},      {"NE", 2, Operator::ne},     {"GT", 2, Operator::gt},
    {"GE", 2, Operator::ge},      {"LT", 2, Operator::lt},     {"LE", 2, Operator::le},
    {"AND", 1, Operator::both},   {"OR", 1, Operator::either}, {"XOR", 1, Operator::one},
};

std::optional<std::size_t> ExpressionReader::next_operator() noexcept {
    for (std::size_t i = 0; i < kOperatorCount; ++i)
        if (take(kOperators[i].text)) return i;
    return std::nullopt;
}

bool ExpressionReader::read_operations(int least_strength, double& value) {
    if (!read_value(value)) return false;
    for (;;) {
        const std::size_t before = at_;
        const auto found = next_operator();
        if (!found) return true;
        const OperatorEntry& entry = kOperators[*found];
        if (entry.strength < least_strength) {
            at_ = before;
            return true;
        }
        double right = 0.0;
        if (!read_operations(entry.strength + 1, right)) return false;
        if (!is_judging_ && !operate(entry.operation, before, value, right)) return false;
    }
}

bool ExpressionReader::operate(Operator operation, std::size_t index, double& left, double right) {
    const auto impossible = [&](Phrase what) {
        return fail(index, ProblemCode::value_impossible, std::move(what));
    };
    switch (operation) {
        case Operator::power:
            if (left < 0.0 && right != std::floor(right))
                return impossible(phrase("a negative number to a power that is not whole"));
            left = std::pow(left, right);
            break;
        case Operator::product:
            left *= right;
            break;
        case Operator::quotient:
            if (right == 0.0) return impossible(phrase("a division by 0"));
            left /= right;
            break;
        case Operator::modulo:
            if (right == 0.0) return impossible(phrase("a division by 0"));
            left = std::fmod(left, right);
            if (left < 0.0) left += std::abs(right);
            break;
        case Operator::sum:
            left += right;
            break;
        case Operator::difference:
            left -= right;
            break;
        case Operator::eq:
            left = truth(std::abs(left - right) < kSameValue);
            break;
        case Operator::ne:
            left = truth(!(std::abs(left - right) < kSameValue));
            break;
        case Operator::gt:
            left = truth(left > right);
            break;
        case Operator::ge:
            left = truth(left >= right);
            break;
        case Operator::lt:
            left = truth(left < right);
            break;
        case Operator::le:
            left = truth(left <= right);
            break;
        case Operator::both:
            left = truth(left != 0.0 && right != 0.0);
            break;
        case Operator::either:
            left = truth(left != 0.0 || right != 0.0);
            break;
        case Operator::one:
            left = truth((left != 0.0) != (right != 0.0));
            break;
    }
    return keep_finite(index, left);
}

bool ExpressionReader::read_function(double& value) {
    struct FunctionEntry {
        std::string_view name;
        Function function;
    };
    // EXISTS stands before EXP.
    static constexpr std::array<FunctionEntry, 14> kFunctions{{{"ABS", Function::abs},
                                                               {"ACOS", Function::acos},
                                                               {"ASIN", Function::asin},
                                                               {"ATAN", Function::atan},
                                                               {"COS", Function::cos},
                                                               {"EXISTS", Function::exists},
                                                               {"EXP", Function::exp},
                                                               {"FIX", Function::fix},
                                                               {"FUP", Function::fup},
                                                               {"LN", Function::ln},
                                                               {"ROUND", Function::round},
                                                               {"SIN", Function::sin},
                                                               {"SQRT", Function::sqrt},
                                                               {"TAN", Function::tan}}};
    const std::size_t begin = at_;
    for (const FunctionEntry& entry : kFunctions) {
        if (!take(entry.name)) continue;
        if (entry.function == Function::exists) return read_exists(value);
        if (!read_bracketed(value)) return false;
        if (entry.function != Function::atan)
            return is_judging_ || (apply(entry.function, begin, value) && keep_finite(begin, value));
        if (!take("/"))
            return fail(at_, ProblemCode::expression_wrong, phrase("ATAN takes two values: ATAN[y]/[x]"));
        double across = 0.0;
        if (!read_bracketed(across)) return false;
        value = deg_from_rad(std::atan2(value, across));
        return true;
    }
    return fail(begin, ProblemCode::expression_wrong, phrase("no function begins so"));
}

bool ExpressionReader::read_exists(double& value) {
    if (!take("[")) return fail(at_, ProblemCode::bracket_missing, phrase("[ is missing"));
    if (!take("#")) return fail(at_, ProblemCode::expression_wrong, phrase("EXISTS asks for a parameter"));
    ParameterKey key;
    if (!read_key(key)) return false;
    if (!take("]")) return fail(at_, ProblemCode::bracket_missing, phrase("EXISTS[ has no ]"));
    value = truth(parameters_.exists(key));
    return true;
}

bool ExpressionReader::apply(Function function, std::size_t index, double& value) {
    const auto impossible = [&](Phrase what) {
        return fail(index, ProblemCode::value_impossible, std::move(what));
    };
    switch (function) {
        case Function::abs:
            value = std::abs(value);
            break;
        case Function::acos:
            if (!(std::abs(value) <= 1.0)) return impossible(phrase("ACOS of a value beyond 1"));
            value = deg_from_rad(std::acos(value));
            break;
        case Function::asin:
            if (!(std::abs(value) <= 1.0)) return impossible(phrase("ASIN of a value beyond 1"));
            value = deg_from_rad(std::asin(value));
            break;
        case Function::cos:
            value = std::cos(rad_from_deg(value));
            break;
        case Function::exp:
            value = std::exp(value);
            break;
        case Function::fix:
            value = std::floor(value);
            break;
        case Function::fup:
            value = std::ceil(value);
            break;
        case Function::ln:
            if (!(value > 0.0)) return impossible(phrase("LN of a value that is not above 0"));
            value = std::log(value);
            break;
        case Function::round:
            value = std::round(value);
            break;
        case Function::sin:
            value = std::sin(rad_from_deg(value));
            break;
        case Function::sqrt:
            if (value < 0.0) return impossible(phrase("SQRT of a value below 0"));
            value = std::sqrt(value);
            break;
        case Function::tan:
            value = std::tan(rad_from_deg(value));
            break;
        case Function::atan:
        case Function::exists:
            break;
    }
    return true;
}

}  // namespace psicarve::gcode
