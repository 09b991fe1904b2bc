// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "hmi/cli/command_set.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::cli {

/// Which holds are told: each once, also where several of a kind come one after the other.
class ToldHold {
public:
    /// Whether the program is held as it was not when asked last.
    bool is_new(ProgramHold hold, std::uint64_t sequence) noexcept {
        const bool is_same = hold == hold_ && (hold == ProgramHold::none || sequence == sequence_);
        hold_ = hold;
        sequence_ = sequence;
        return !is_same && hold != ProgramHold::none;
    }

private:
    ProgramHold hold_ = ProgramHold::none;
    std::uint64_t sequence_ = 0;  ///< of the motion record at hand
};

/// Watches a running program for the person at the terminal: shows the line, says why it holds, and passes
/// Ctrl-C on to the core.
class ProgramWatch {
public:
    /// `line_count`: of the program, 0: not known. All outlive this, `operator_break` until the report is
    /// printed. `follow`: who else looks; empty: none.
    ProgramWatch(machine::MachineLink& link, OperatorBreak& operator_break, std::uint64_t line_count,
                 std::function<void(const ProgramReport&)> follow = {})
        : link_(link),
          operator_break_(operator_break),
          bar_("starting"),
          line_count_(line_count),
          follow_(std::move(follow)) {}

    Result<void> look(const CoreStatus& status);
    /// The operator is not asked for anything: holds are not told.
    void keep_quiet(const char* label) noexcept { quiet_label_ = label; }
    /// The highest feed that was seen, and whether the machine was held.
    std::uint32_t most_override_percent() const noexcept { return most_override_percent_; }
    bool was_held() const noexcept { return was_held_; }

private:
    void tell_hold(const ProgramReport& report);

    machine::MachineLink& link_;
    OperatorBreak& operator_break_;
    ProgressBar bar_;
    std::uint64_t line_count_;
    std::function<void(const ProgramReport&)> follow_;
    ToldHold told_hold_;
    std::uint32_t most_override_percent_ = 0;
    bool was_held_ = false;
    const char* quiet_label_ = nullptr;  ///< null: holds are told
};

/// What a program that was run to its end came to.
struct ProgramRun {
    ProgramStatus program{};
    double seconds = 0.0;                     ///< of the machine
    std::uint32_t most_override_percent = 0;  ///< of the feed
    bool was_held = false;                    ///< by whomever
};

struct ProgramStart {
    std::uint64_t program;   ///< its number
    std::uint32_t switches;  ///< kProgram... bits
    CoreStatus status;       ///< where the machine stood when the program was read
};
/// Asks the core to run the program whose records are being written, and waits until the machine is ready
/// again. An error when it was not run to its end, or the machine has moved since it was read.
Result<ProgramRun> run_program(machine::MachineLink& link, const ProgramStart& start, ProgramWatch& watch);

}  // namespace psicarve::cli
