// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "shared/base/result.hpp"
#include "shared/program/record_ring.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve {

// A program on its way into the core, record by record. One process writes at a time:
//
//     writer   claim ──▶ ask ─────────────▶ put ... put ──▶ close ──▶ release
//     core              └─▶ open: a number ──▶ take ... take ──▶ end
//
// A writer that is killed leaves its claim behind; whoever claims next, or the core that looks, frees it.

enum class ProgramPut : std::uint8_t {
    done,
    full,     ///< no room within the time limit; nothing was put
    over,     ///< the core takes no more of this program; program_report() says why
    no_core,  ///< the core that took it serves the segment no more
    damaged,  ///< the ring's words are overwritten
    closed,   ///< the program has no number yet, or its end was put, or it was closed
};

/// The side that writes. Move-only; releases its claim when destroyed, and closes nothing then: a program
/// without its end is a lost one. The segment must outlive it. One thread at a time.
class ProgramWriter {
public:
    /// Refused, with its pid, while a living process has it. ErrorCode::machine_refused then.
    static Result<ProgramWriter> claim(Segment& segment);
    ProgramWriter(ProgramWriter&& other) noexcept;
    ProgramWriter& operator=(ProgramWriter&& other) noexcept;
    ProgramWriter(const ProgramWriter&) = delete;
    ProgramWriter& operator=(const ProgramWriter&) = delete;
    ~ProgramWriter();

    /// Asks the core for a program, and waits until it has given its number. no_core, timed_out.
    Result<void> begin(std::chrono::milliseconds limit);
    /// Of the program that has begun; 0: none.
    std::uint64_t program() const noexcept { return program_; }
    /// Sequence of the last record put.
    std::uint64_t sequence() const noexcept { return sequence_; }

    /// Puts a record, whose program, sequence and check this fills in; waits for room as long as the core
    /// lives. After a record of kind `end` none is put any more.
    ProgramPut put(const MotionRecord& record) noexcept;
    ProgramPut try_put(const MotionRecord& record) noexcept;
    ProgramPut put_for(const MotionRecord& record, std::chrono::nanoseconds limit) noexcept;
    /// Why a put failed, in words and as a message. Requires an answer that is not `done`.
    Error error_of(ProgramPut answer) const;

    /// What holds where the machine is: for those who look on. Does nothing without a program.
    void tell(const ProgramModes& modes) noexcept;
    /// What its records are made of, for a replay. Does nothing without a program.
    void tell(const ProgramSource& source) noexcept;
    /// Nothing more comes: what is queued needs no writer from here on.
    void close() noexcept;
    void release() noexcept;

private:
    ProgramWriter(Segment& segment, std::uint64_t claim) noexcept : segment_(&segment), claim_(claim) {}
    bool accepts() const noexcept;
    std::optional<ProgramPut> refusal() const noexcept;
    bool has_same_core() const noexcept;
    ProgramPut ended() const noexcept;
    MotionRecord signed_copy(const MotionRecord& record) const noexcept;
    ProgramPut outcome(RingAnswer answer, const MotionRecord& record) noexcept;

    Segment* segment_ = nullptr;
    std::uint64_t claim_ = 0;
    std::uint64_t program_ = 0;
    std::uint32_t core_pid_ = 0;  ///< of the core that gave the number; 0: it had not signed yet
    std::uint64_t core_start_time_ = 0;
    std::uint64_t sequence_ = 0;
    bool has_end_ = false;
    std::optional<RecordWriter> ring_;
};

/// What the core says of the program, for any process. Each part is whole in itself.
struct ProgramReport {
    std::uint32_t writer_pid = 0;  ///< who has the claim, alive or not; 0: nobody
    std::uint64_t running = 0;     ///< the program whose records the core takes; 0: of none
    ProgramStatus status{};        ///< how far the machine is in it; of another program until it runs
    ProgramProgress progress{};    ///< of the program that runs, or ran last
    std::optional<ProgramRefusal> refusal{};  ///< of that program
    std::optional<ProgramModes>
        modes{};  ///< of the program of `status`; its writer tells them, some time later
    std::optional<ProgramOrigin> origin{};  ///< of the program of `status`; nothing: not told
    std::uint32_t queued = 0;               ///< records in the ring
    std::uint32_t ring_records = 0;         ///< that it has room for
};
ProgramReport program_report(const Segment& segment) noexcept;
/// Of the program that runs, or ran last, and what the core has taken of it. Null: its writer told nothing.
std::shared_ptr<const RecordedSource> recorded_source(const Segment& segment);

// --- core side
// -------------------------------------------------------------------------------------------------

/// One open program as the core sees it: its records, and whether its writer is still there. Neither is
/// trusted. One thread at a time.
class ProgramFeed {
public:
    /// `control` and `ring` must outlive it.
    ProgramFeed(ProgramControl& control, const RecordRing& ring, const ProgramGrant& grant) noexcept
        : control_(&control), reader_(ring, grant.first), grant_(grant) {}

    std::uint64_t program() const noexcept { return grant_.program; }
    std::uint64_t claim() const noexcept { return grant_.claim; }
    RingAnswer take(MotionRecord& record) noexcept { return reader_.take(record); }
    RingAnswer wait_for(std::chrono::nanoseconds limit) noexcept { return reader_.wait_for(limit); }
    std::uint64_t queued() noexcept { return reader_.queued(); }
    /// Nothing more comes, for certain: the program is closed, or its writer is dead or has let go. What it
    /// put before that can be taken: look at the ring once more after this was true.
    bool is_left() const noexcept;
    /// The process that asked for it lives and has not let go.
    bool has_writer() const noexcept;

    /// `record_sum`: with_record() over those taken.
    void say(std::uint64_t taken, std::uint64_t line, ProgramEnd end, std::uint64_t record_sum) noexcept;
    void say_refusal(std::uint64_t line, const Message& why) noexcept;

private:
    ProgramControl* control_;
    RecordReader reader_;
    ProgramGrant grant_;
};

/// Opens and ends programs. For the core alone; not for the tick.
class ProgramDesk {
public:
    /// `last_program`: the last number that this core has given, also of a segment before this one: no number
    /// comes twice in its life. The segment must outlive it.
    explicit ProgramDesk(Segment& segment, std::uint64_t last_program = 0) noexcept
        : segment_(&segment), last_program_(last_program) {}

    /// The living writer that waits for a number; frees the claim of a dead one.
    std::optional<std::uint32_t> waiting_writer() noexcept;
    /// The writer of this claim, which has a number, wants another one.
    bool asks_again(std::uint64_t claim) const noexcept;
    /// Gives it the next number. Nothing: no writer waits. The program before must have ended.
    std::optional<ProgramFeed> open(std::uint64_t first = 0) noexcept;
    /// Takes no more of the program; what is queued of it is forgotten.
    void end() noexcept;
    /// How far the machine is.
    void tell(const ProgramStatus& status) noexcept;
    std::uint64_t last_program() const noexcept { return last_program_; }

private:
    Segment* segment_;
    std::uint64_t last_program_;
};

/// A core that has just claimed the segment calls this: the program before it is over.
void clear_program_of_dead_core(SegmentHeader& header) noexcept;

}  // namespace psicarve
