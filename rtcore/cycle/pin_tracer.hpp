// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/machine/recording_form.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// Tells the trace ring every change of a pin, and every position that is defined anew: always, or while a
/// process has the pins recorded. Waits for no reader: what finds the ring full is counted as lost. Levels
/// are those of all pins at that moment, the charge pump apart. io outlives it. RT: yes.
class PinTracer {
public:
    using Positions = std::array<std::int64_t, kAxisCount>;

    explicit PinTracer(CycleIo& io) noexcept : io_(&io) {}

    bool is_on() const noexcept {
        return io_->trace != nullptr && (io_->traces_always || recording_token_ != 0);
    }

    /// Every tick: a change since the trace was told last.
    void trace_change(SignalWord levels, std::uint64_t tick) noexcept {
        if (levels != traced_ && is_on()) trace_pins(levels, tick, 0);
    }
    /// Requires is_on(). What is lost stays a change: the next trace_change() tells it.
    void trace_pins(SignalWord levels, std::uint64_t tick, std::int64_t offset_ns) noexcept;

    /// Of this tick; told after its pins, because what is counted from then on includes their pulses.
    void note_new_position() noexcept { has_new_position_ = true; }
    bool has_new_position() const noexcept { return has_new_position_; }
    void trace_position(SignalWord levels, std::uint64_t tick, const Positions& positions_pulses) noexcept;

    /// What the pins do from here on is the job of this generation. Where not everything is traced, nothing.
    void trace_job(SignalWord levels, std::uint64_t tick, const Positions& positions_pulses,
                   std::uint64_t generation) noexcept;

    /// Whether a recording could begin now: there is a ring for it, and no other goes on.
    bool can_record() const noexcept { return io_->trace != nullptr && recording_token_ == 0; }
    /// Where the tips stand, and how much of its screw's gap each motor has crossed downwards.
    struct Stand {
        Positions positions_pulses{};
        Positions crossed_pulses{};
    };
    /// Requires can_record(), and a form that is not none.
    void begin_recording(RecordingForm form, std::uint32_t token, SignalWord levels, std::uint64_t tick,
                         const Stand& stand) noexcept;
    /// `token` 0: any owner's. False: it is another's. Done as well when there is none.
    bool end_recording(std::uint32_t token, SignalWord levels, std::uint64_t tick,
                       const Positions& positions_pulses) noexcept;

    std::uint64_t lost() const noexcept { return lost_; }

private:
    using Kind = trace::TraceEntry::Kind;

    void trace_all(Kind kind, std::uint32_t token, SignalWord levels, std::uint64_t tick,
                   const Positions& positions_pulses, const Positions& crossed_pulses = {}) noexcept;

    CycleIo* io_;
    SignalWord traced_ = 0;
    std::uint32_t recording_token_ = 0;  ///< whose recording goes on; 0: none
    bool has_new_position_ = false;
    std::uint64_t lost_ = 0;
};

}  // namespace psicarve::cycle
