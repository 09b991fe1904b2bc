// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hmi/gcode/parameters.hpp"
#include "hmi/gcode/problem.hpp"

namespace psicarve::gcode {

/// What is wrong in a line, and at which of its bytes.
struct LineFault {
    std::size_t index = 0;
    ProblemCode code = ProblemCode::expression_wrong;
    Phrase what;
};

/// Reads values of one line, as RS274/NGC and LinuxCNC 2.9 have them: numbers, parameters, [expressions] and
/// functions, blanks anywhere. Operators from the strongest, all from left to right: **; * / MOD; + -; EQ NE
/// GT GE LT LE; AND OR XOR.
class ExpressionReader {
public:
    /// `is_judging`: only how it is written is judged, and all values are 1.
    ExpressionReader(std::string_view line, std::size_t at, Parameters& parameters, bool is_judging) noexcept
        : line_(line), at_(at), parameters_(parameters), is_judging_(is_judging) {}

    /// Of everything that can stand behind a letter. False: see fault().
    bool read_value(double& value);
    /// Of what begins with [.
    bool read_bracketed(double& value);
    /// A parameter's number or name, behind its #.
    bool read_key(ParameterKey& key);
    /// A name in < >.
    bool read_name(std::string& name);

    /// Passes the text and blanks before it; the same letters large or small.
    bool take(std::string_view text) noexcept;
    bool is_next(char byte) noexcept;
    bool is_at_end() noexcept;
    /// Whether a digit, a point or a sign is next.
    bool starts_number() noexcept;

    void go_to(std::size_t index) noexcept { at_ = index; }
    std::size_t at() const noexcept { return at_; }
    /// Requires that reading has failed.
    const LineFault& fault() const noexcept { return *fault_; }

private:
    enum class Operator : std::uint8_t;
    enum class Function : std::uint8_t;
    struct OperatorEntry;
    static const OperatorEntry kOperators[];

    bool fail(std::size_t index, ProblemCode code, Phrase what);
    void skip_blanks() noexcept;
    bool read_plain(double& value);
    bool read_parameter(double& value);
    bool read_function(double& value);
    bool read_exists(double& value);
    bool read_operations(int least_strength, double& value);
    std::optional<std::size_t> next_operator() noexcept;
    bool operate(Operator operation, std::size_t index, double& left, double right);
    bool apply(Function function, std::size_t index, double& value);
    bool keep_finite(std::size_t index, double value);

    std::string_view line_;
    std::size_t at_;
    Parameters& parameters_;
    bool is_judging_;
    int depth_ = 0;
    std::optional<LineFault> fault_;
};

}  // namespace psicarve::gcode
