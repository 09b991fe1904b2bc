// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <thread>

#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/line_source.hpp"
#include "hmi/gcode/modes_trail.hpp"
#include "hmi/gcode/problem.hpp"
#include "hmi/gcode/program_check.hpp"
#include "hmi/gcode/record_maker.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::cli {

/// Reads a program in G-code, judges each block, and writes what it means into the core's ring, all in a
/// thread of its own: it waits for room as long as the core lives, so a program may be of any length.
///
/// A block that is wrong ends the program in front of it: the machine comes to rest there, spindle off.
class RecordFeeder {
public:
    struct Program {
        gcode::ProgramBytes bytes;
        int awaited_fd = -1;  ///< read when it has something, which may be never; -1: at once
        gcode::InterpreterOptions language;
        gcode::RunOptions run;
        /// In the thread, before the end of a program that is right is written: what it leaves.
        std::function<void(const gcode::KeptOffsets&)> before_end{};
        std::size_t ring_records = 0;  ///< that the ring has room for
        /// No more are written, and then not the program's end either.
        std::uint64_t most_records = std::numeric_limits<std::uint64_t>::max();
    };
    /// The writer has begun its program, and outlives this.
    RecordFeeder(Program program, const Profile& profile, ProgramWriter& writer);
    /// Gives up what is not written yet.
    ~RecordFeeder();
    RecordFeeder(const RecordFeeder&) = delete;
    RecordFeeder& operator=(const RecordFeeder&) = delete;

    void give_up() noexcept { is_given_up_.store(true); }
    /// Until it is done.
    void wait();
    /// Everything is written, or nothing more will be.
    bool is_done() const noexcept { return is_done_.load(std::memory_order_acquire); }
    std::uint64_t records_written() const noexcept { return records_written_.load(); }
    /// What holds for each record that was written and is not done.
    gcode::ModesTrail& trail() noexcept { return trail_; }

    // Once it is done:
    /// What holds behind the last block that was taken.
    const gcode::KeptOffsets& offsets() const noexcept { return offsets_; }
    const gcode::ProblemList& problems() const noexcept { return problems_; }
    /// Of what was read.
    const gcode::ProgramFacts& facts() const noexcept { return facts_; }
    /// Why not all of the program was written, apart from what is wrong with it: the core took no more, the
    /// bytes cannot be read.
    const std::optional<Error>& failure() const noexcept { return failure_; }

private:
    class Sink;

    void feed(Program program, const Profile& profile);
    gcode::ProgramBytes patient(gcode::ProgramBytes bytes, int awaited_fd) const;

    ProgramWriter& writer_;
    std::atomic<bool> is_given_up_{false};
    std::atomic<bool> is_done_{false};
    std::atomic<std::uint64_t> records_written_{0};
    gcode::ModesTrail trail_;
    gcode::KeptOffsets offsets_;
    gcode::ProblemList problems_;
    gcode::ProgramFacts facts_;
    std::optional<Error> failure_;
    std::thread thread_;
};

}  // namespace psicarve::cli
