// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/gcode/line_source.hpp"
#include "hmi/gcode/o_word_reader.hpp"
#include "hmi/gcode/parameters.hpp"
#include "hmi/gcode/problem.hpp"
#include "shared/base/result.hpp"

namespace psicarve::gcode {

/// M98, as its block has it.
struct CallByNumber {
    std::uint64_t number = 0;
    std::uint64_t times = 1;
    std::uint64_t line = 0;
    std::uint32_t column = 0;
};

/// Which line of a program comes next: loops, branches, subroutines. Blocks lie one within the other; each
/// call has its own. A loop's or a subroutine's lines are read again from the source.
class FlowControl {
public:
    /// Nothing, or what is wrong with the line. An error: the program cannot be read any more.
    using Outcome = Result<std::optional<Problem>>;

    /// Source and parameters outlive this.
    FlowControl(LineSource& lines, Parameters& parameters, bool skips_deleted) noexcept
        : lines_(lines), parameters_(parameters), skips_deleted_(skips_deleted) {}

    /// An O word was met, or M98.
    bool has_begun() const noexcept { return has_begun_; }
    /// Where the subroutine begins that is called; 0: the main program is run.
    std::uint64_t called_line() const noexcept { return calls_.empty() ? 0 : calls_.back().body.line; }
    /// False: lines are passed over, as in a branch that is not taken.
    bool is_running() const noexcept { return is_running_below(frames_.size()); }

    /// The line of an O word that begins at this index. It was the last one that the source gave.
    Outcome run(std::string_view line, std::size_t o_word);
    /// The program has ended: whether blocks of its own are open, whose ends alone are sought from here on.
    bool pass_over() noexcept;
    /// A line behind pass_over().
    Outcome pass(std::string_view line);
    /// Only how it is written.
    std::optional<Problem> judge(std::string_view line, std::size_t o_word);
    Outcome call(const CallByNumber& call);
    /// M99.
    Outcome go_back(std::uint64_t line, std::uint32_t column);
    /// What is wrong where the program's lines end.
    std::optional<Problem> unclosed() const;

private:
    /// A block that is open.
    struct Frame {
        OKeyword kind = OKeyword::sub;  ///< sub, if_so, do_so, while_so or repeat
        std::string name;
        std::uint64_t line = 0;
        std::uint32_t column = 0;
        bool is_running = false;  ///< as far as this block decides
        bool is_over = false;     ///< if: a branch has been run, or none is to be; loop: no further pass
        bool is_last = false;     ///< if: behind else
        bool is_called = false;   ///< sub: not only passed over
        bool is_held = false;
        std::uint64_t passes_left = 0;
        LinePlace body{};
        std::string condition;  ///< while: its line
    };
    struct Call {
        LinePlace back{};
        LinePlace body{};
        std::size_t first_frame = 0;
        bool is_by_number = false;
        std::uint64_t times_left = 0;
        std::uint64_t line = 0;
        std::uint32_t column = 0;
    };
    struct Subroutine {
        LinePlace body{};
        std::uint64_t line = 0;
        bool is_by_number = false;
    };
    using Fault = std::optional<Problem>;

    std::size_t first_frame() const noexcept { return calls_.empty() ? 0 : calls_.back().first_frame; }
    bool is_running_below(std::size_t end) const noexcept;

    Outcome dispatch(OWordReader& reader, const OWord& word, std::string_view line);
    Fault begin_block(OWordReader& reader, const OWord& word, Frame frame);
    Outcome end_do(OWordReader& reader, const OWord& word);
    Fault begin_if(OWordReader& reader, const OWord& word);
    Fault branch(OWordReader& reader, const OWord& word);
    Fault begin_loop(OWordReader& reader, const OWord& word, std::string_view line);
    Outcome end_loop(OWordReader& reader, const OWord& word, OKeyword kind);
    Outcome end_pass(bool goes_on);
    Fault leave_pass(OWordReader& reader, const OWord& word);
    Result<bool> is_condition_met(const Frame& frame, Fault& wrong);
    Fault match(const OWordReader& reader, const OWord& word, OKeyword kind) const;
    void pop_frame();
    void pop_to(std::size_t count);

    Fault define(OWordReader& reader, const OWord& word);
    Fault enter_label(const OWordReader& reader, const OWord& word);
    Fault enter_name(const std::string& name, const Subroutine& subroutine, std::uint32_t column);
    Outcome end_sub(OWordReader& reader, const OWord& word);
    Outcome give_back(OWordReader& reader, const OWord& word);
    Outcome call_by_name(OWordReader& reader, const OWord& word);
    Outcome leave_call(std::optional<double> returned);
    Outcome find(const std::string& name, const Subroutine*& found);
    Outcome look_ahead();
    Fault note_ahead(std::string_view line);

    LineSource& lines_;
    Parameters& parameters_;
    bool skips_deleted_;
    bool has_begun_ = false;
    bool has_looked_ahead_ = false;
    std::vector<Frame> frames_;
    std::vector<Call> calls_;
    std::map<std::string, Subroutine, std::less<>> subroutines_;
    std::vector<double> values_;
};

}  // namespace psicarve::gcode
