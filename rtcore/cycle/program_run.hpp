// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/machine/command.hpp"
#include "shared/machine/program_status.hpp"

namespace psicarve::cycle {

/// The program of motion records at hand: how far it is, what it waits for, and whether it starves. Its
/// figures outlive it, until the next begins. RT: yes.
class ProgramRun {
public:
    /// So long the machine rests without a next block before that is told: no wait of a writer's turn, and
    /// nothing that an operator would call a stop.
    static constexpr std::int64_t kPatience_ns = 200'000'000;

    /// Its line is told no more often than this, and that it starved.
    static constexpr std::int64_t kTelling_ns = 1'000'000'000;

    ProgramRun(std::int64_t step_ns, std::int64_t tick_ns) noexcept
        : patience_steps_(kPatience_ns / step_ns),
          telling_ticks_(static_cast<std::uint64_t>(kTelling_ns / tick_ns)) {}

    /// `switches`: kProgram... bits.
    void begin(std::uint64_t program, std::uint32_t switches) noexcept {
        status_ = ProgramStatus{};
        status_.program = program;
        status_.is_running = 1;
        status_.is_single = (switches & kProgramIsSingle) != 0 ? 1 : 0;
        status_.stops_at_optional = (switches & kProgramStopsAtOptional) != 0 ? 1 : 0;
        empty_steps_ = 0;
        untold_starvations_ = 0;
        starvations_tick_ = 0;
        has_begun_ = false;
    }
    void set_single(bool is_on) noexcept { status_.is_single = is_on ? 1 : 0; }
    void set_optional_stop(bool is_on) noexcept { status_.stops_at_optional = is_on ? 1 : 0; }
    /// kProgram... bits of what is switched on now.
    std::uint8_t switches() const noexcept {
        return static_cast<std::uint8_t>((status_.is_single != 0 ? kProgramIsSingle : 0) |
                                         (status_.stops_at_optional != 0 ? kProgramStopsAtOptional : 0));
    }
    /// Its last block is done.
    void note_done() noexcept { status_.is_done = 1; }
    void end() noexcept {
        status_.is_running = 0;
        status_.hold = ProgramHold::none;
    }
    bool is_on() const noexcept { return status_.is_running != 0; }

    /// Line and record of the motion at hand. Line 0: it has none.
    void note_line(std::uint64_t line, std::uint64_t sequence) noexcept {
        if (line == 0) return;
        status_.line = line;
        status_.sequence = sequence;
    }
    /// It rests, and waits for the operator or for records.
    void wait_for(ProgramHold hold) noexcept { status_.hold = hold; }
    void go_on() noexcept {
        status_.hold = ProgramHold::none;
        empty_steps_ = 0;
    }
    ProgramHold hold() const noexcept { return status_.hold; }
    /// Records alone are awaited: with them it goes on by itself.
    bool is_starved() const noexcept { return status_.hold == ProgramHold::starved; }

    /// Each step of the interpolation in which it runs and a motion begins, or none is under way. True, once:
    /// from now on it starves, and that was counted. Before its first block it does not.
    bool runs_out(bool has_run_out) noexcept {
        if (!has_run_out) {
            empty_steps_ = 0;
            has_begun_ = true;
            return false;
        }
        if (!has_begun_ || ++empty_steps_ < patience_steps_) return false;
        wait_for(ProgramHold::starved);
        ++status_.starvations;
        ++untold_starvations_;
        return true;
    }

    /// So often it has starved since the flight recorder was told; it may be told of that now.
    std::uint32_t untold_starvations() const noexcept { return untold_starvations_; }
    bool may_tell_starvations(std::uint64_t tick) const noexcept { return tick >= starvations_tick_; }
    void note_starvations_told(std::uint64_t tick) noexcept {
        untold_starvations_ = 0;
        starvations_tick_ = tick + telling_ticks_;
    }

    /// The flight recorder has been told of it, and with that of its motion record.
    void note_told(std::uint64_t sequence, std::uint64_t tick) noexcept {
        told_sequence_ = sequence;
        telling_tick_ = tick + telling_ticks_;
    }
    /// Whether its line is to be told again, where that is no more often than it may be. A loop comes to the
    /// same line with other motion records.
    bool may_be_told(std::uint64_t tick) const noexcept { return tick >= telling_tick_; }
    bool is_told(std::uint64_t sequence) const noexcept { return sequence == told_sequence_; }

    const ProgramStatus& status() const noexcept { return status_; }

private:
    ProgramStatus status_{};
    std::int64_t patience_steps_;
    std::uint64_t telling_ticks_;
    std::uint64_t telling_tick_ = 0;  ///< not before this one
    std::uint64_t told_sequence_ = 0;
    std::uint64_t starvations_tick_ = 0;  ///< nor of starvations
    std::uint32_t untold_starvations_ = 0;
    std::int64_t empty_steps_ = 0;
    bool has_begun_ = false;  ///< a block of it came
};

}  // namespace psicarve::cycle
