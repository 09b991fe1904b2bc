// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/pin_tracer.hpp"

namespace psicarve::cycle {

void PinTracer::trace_pins(SignalWord levels, std::uint64_t tick, std::int64_t offset_ns) noexcept {
    trace::TraceEntry entry{};
    entry.tick = tick;
    entry.offset_ns = static_cast<std::uint32_t>(offset_ns);
    entry.levels = levels;
    entry.kind = Kind::pins;
    if (io_->trace->push(entry)) {
        traced_ = levels;
    } else {
        ++lost_;
    }
}

void PinTracer::trace_position(SignalWord levels, std::uint64_t tick,
                               const Positions& positions_pulses) noexcept {
    has_new_position_ = false;
    if (is_on()) trace_all(Kind::position, 0, levels, tick, positions_pulses);
}

void PinTracer::trace_job(SignalWord levels, std::uint64_t tick, const Positions& positions_pulses,
                          std::uint64_t generation) noexcept {
    if (io_->trace == nullptr || !io_->traces_always) return;
    trace_all(Kind::job, static_cast<std::uint32_t>(generation), levels, tick, positions_pulses);
}

void PinTracer::begin_recording(RecordingForm form, std::uint32_t token, SignalWord levels,
                                std::uint64_t tick, const Stand& stand) noexcept {
    recording_token_ = token;
    traced_ = levels;
    trace_all(form == RecordingForm::vcd ? Kind::begin_vcd : Kind::begin_binary, token, levels, tick,
              stand.positions_pulses, stand.crossed_pulses);
}

bool PinTracer::end_recording(std::uint32_t token, SignalWord levels, std::uint64_t tick,
                              const Positions& positions_pulses) noexcept {
    if (recording_token_ == 0) return true;
    if (token != 0 && token != recording_token_) return false;
    trace_all(Kind::end, recording_token_, levels, tick, positions_pulses);
    recording_token_ = 0;
    return true;
}

/// Everything that is known about the pins at this tick.
void PinTracer::trace_all(Kind kind, std::uint32_t token, SignalWord levels, std::uint64_t tick,
                          const Positions& positions_pulses, const Positions& crossed_pulses) noexcept {
    trace::TraceEntry entry{};
    entry.tick = tick;
    entry.levels = levels;
    entry.kind = kind;
    entry.token = token;
    entry.position_pulses = positions_pulses;
    entry.crossed_pulses = crossed_pulses;
    if (!io_->trace->push(entry)) ++lost_;
}

}  // namespace psicarve::cycle
