// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "rtcore/journal/journal_allowance.hpp"
#include "rtcore/journal/journal_writer.hpp"
#include "rtcore/process/side_thread.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/record/journal.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// What a core records of itself when it begins.
struct JournalStart {
    JournalPlace place;
    std::uint64_t profile_hash = 0;
    std::string port_name;
    bool is_virtual_clock = false;
};

/// Writes down what happens to the machine, for readers after this core has ended. A thread of its own
/// writes; the caller never waits for it. Without a folder it does nothing. Used by one thread.
class Journal {
public:
    explicit Journal(const JournalStart& start);

    /// Before the reports that a sample was read for: why a program that is held for good broke off.
    void note_program(const Segment& segment, const cycle::Sample& sample);
    /// Call it for every report of the tick. `sample`: no older than it; `job`: the current one, or null.
    void note_report(const cycle::Report& report, const cycle::Sample& sample, const LoadedJob* job);
    /// Before the sender is told: afterwards it may be gone.
    void note_answer(const ReceivedCommand& received, AnswerKind kind, const Message& why,
                     std::uint64_t tick);
    /// A published job became the current one.
    void note_job(const LoadedJob& job, std::uint64_t tick);
    void note_refused_job(const Message& why, std::uint64_t tick);
    /// Every round.
    void note_round(const cycle::Sample& sample);
    /// The last call: nothing is written after it. Waits until all is written, but only as long as a
    /// SideThread does for a disk that hangs.
    void note_end(const cycle::Sample& sample);

private:
    using Time = std::chrono::steady_clock::time_point;
    void note_state(MachineState entered, const cycle::Sample& sample, const LoadedJob* job);
    void note_program_record(const FlightRecord& record);
    void note_program_state(MachineState before, MachineState entered, std::uint64_t tick);
    void put(JournalKind kind, std::string what, std::uint64_t tick, JournalFacts facts);
    void put_always(JournalKind kind, std::string what, std::uint64_t tick, JournalFacts facts);
    void tell_left_out(JournalKind kind, std::uint64_t count, std::uint64_t tick);
    void tell_missed(const cycle::Sample& sample);
    bool may_put(JournalKind kind) noexcept;

    /// shared with the thread, which may outlive this; null: nothing is kept, or no longer
    std::shared_ptr<JournalWriter> writer_;
    std::array<JournalAllowance, kJournalKindCount> allowances_;
    MachineState state_ = MachineState::off;
    bool is_program_ = false;                 ///< what runs, or ran last, was no job
    ProgramStatus program_{};                 ///< the last one, as the reports so far have it
    bool is_hold_told_ = false;               ///< of it, and so is that it goes on
    ProgramHold broken_ = ProgramHold::none;  ///< for good, of the program that runs
    Message why_broken_{};
    std::uint64_t missed_told_ = 0;
    Time next_missed_{};
    std::unique_ptr<rtcore::SideThread> thread_;
};

}  // namespace psicarve::supervisor
