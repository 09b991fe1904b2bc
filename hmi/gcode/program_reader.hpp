// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "hmi/gcode/block.hpp"
#include "hmi/gcode/flow_control.hpp"
#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/parameters.hpp"
#include "hmi/gcode/program_check.hpp"

namespace psicarve::gcode {

/// Reads a program's lines in the order in which they are executed, and has each carried out.
///
/// Where a program with O words has an error, it is not known which way it would go on: what follows is read
/// for how it is written alone. Its members: who carries lines out, how far the reading is, and counts that
/// bound the work of loops; each of the last would be a class of one number.
class ProgramReader {
public:
    /// All outlive the reader.
    ProgramReader(LineSource& lines, const InterpreterOptions& options, CanonSink& sink,
                  ProblemList& problems);

    Result<ProgramFacts> read();

private:
    bool wants_more() const noexcept;
    bool is_frame(std::string_view line);
    bool is_torn(std::string_view line);
    bool is_judging() const noexcept;
    Result<void> leave_flow();
    Result<void> pass_to_block_end();
    bool has_read_plain(std::string_view line);
    Result<void> read_o_word(std::string_view line);
    Result<void> jump();
    void refuse(Problem wrong, std::string_view line);
    void tell(std::optional<Problem> wrong);
    bool is_work_bounded();
    void tell_end();

    LineSource& lines_;
    InterpreterOptions options_;
    CanonSink& sink_;
    ProblemList& problems_;
    std::unique_ptr<Interpreter> interpreter_;
    std::unique_ptr<Parameters> parameters_;
    std::unique_ptr<Block> block_;
    FlowControl flow_;
    bool has_begun_ = false;
    bool is_framed_ = false;
    bool is_given_up_ = false;
    bool has_left_flow_ = false;
    LinePlace furthest_{};  ///< behind the last line of which something is known
    std::uint64_t line_count_ = 0;
    std::uint64_t main_line_count_ = 0;  ///< of the main program, since the first O word
    std::uint64_t repeated_blocks_ = 0;  ///< behind a jump back, or called
    std::uint64_t idle_blocks_ = 0;
    std::uint64_t drawn_chords_ = 0;
    std::uint64_t actions_ = 0;
};

}  // namespace psicarve::gcode
