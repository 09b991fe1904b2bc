// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/cycle/inputs.hpp"
#include "rtcore/cycle/job_run.hpp"
#include "rtcore/cycle/pulse_stage.hpp"
#include "rtcore/cycle/tick_clock.hpp"
#include "rtcore/cycle/verdict.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::cycle {

/// Tells the supervisor what happens, in the order in which it happens, each with the tick, the levels and
/// the positions of that moment. Waits for no reader: what finds the ring full is counted as lost. Clock,
/// pulses, inputs and io outlive it. RT: yes.
class Reporter {
public:
    Reporter(CycleIo& io, const TickClock& clock, const PulseStage& pulses, const Inputs& inputs) noexcept
        : io_(&io), clock_(&clock), pulses_(&pulses), inputs_(&inputs) {}

    /// The meaning of code and value: RecordKind.
    void report(RecordKind kind, std::uint16_t code, std::uint8_t axis = kNoAxis,
                std::int64_t value = 0) noexcept;
    /// Counts are those of steps_lost, as Report has them.
    void report_alarm(AlarmCause cause, std::uint8_t axis, std::int64_t expected_pulses,
                      std::int64_t seen_pulses, JobRun::Affected affected) noexcept;
    /// Where a jog or a move is to go, one record each part: a replay asks for the same again by them.
    void report_order(const MotionOrder& order) noexcept;
    /// Missed ticks, of which so many would do no harm. Half of the ring is kept for other reports: a
    /// harmless gap that finds it full is lost.
    void report_gap(std::uint64_t ticks, std::uint32_t longest_harmless_ticks) noexcept;
    /// What happened to the program, and where it is in it; detail as at ProgramEvent. Its line alone, which
    /// comes again, leaves half of the ring to other reports.
    void report_program(ProgramEvent event, std::uint8_t detail, const ProgramStatus& program) noexcept;
    /// So often it has starved since this was reported last; it is to say so once a second at most.
    void report_starvations(std::uint32_t count, const ProgramStatus& program) noexcept;
    /// Exactly one for each request.
    void answer(const Request& request, Verdict verdict) noexcept;

    std::uint64_t lost() const noexcept { return lost_; }

private:
    FlightRecord record_of(RecordKind kind, std::uint16_t code, std::uint8_t axis,
                           std::int64_t value) const noexcept;
    FlightRecord record_of_program(ProgramEvent event, std::uint8_t detail,
                                   const ProgramStatus& program) const noexcept;
    void push_event(const FlightRecord& record) noexcept;
    void push(const Report& report) noexcept;

    CycleIo* io_;
    const TickClock* clock_;
    const PulseStage* pulses_;
    const Inputs* inputs_;
    std::uint64_t lost_ = 0;
};

}  // namespace psicarve::cycle
