// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"
#include "shared/recording_form.hpp"

namespace psicarve::cycle {

// A recording begins at rest: what it tells from there on is all that moves the machine.
Refusal Cycle::record(const Request& request) noexcept {
    using Kind = trace::TraceEntry::Kind;
    const auto form = static_cast<RecordingForm>(request.value);
    if (form == RecordingForm::none) {
        if (recording_token_ == 0) return Refusal::none;
        if (request.lease_token != 0 && request.lease_token != recording_token_) return Refusal::recording;
        trace_all(Kind::end, recording_token_);
        recording_token_ = 0;
        return Refusal::none;
    }
    if (io_->trace == nullptr || recording_token_ != 0) return Refusal::recording;
    if (state_ != MachineState::off && state_ != MachineState::ready) return Refusal::not_in_this_state;
    recording_token_ = request.lease_token;
    traced_ = (written_ & kOutputMask) | inputs_.raw();
    trace_all(form == RecordingForm::vcd ? Kind::begin_vcd : Kind::begin_binary, recording_token_);
    return Refusal::none;
}

/// Everything that is known about the pins at this tick.
void Cycle::trace_all(trace::TraceEntry::Kind kind, std::uint32_t token) noexcept {
    trace::TraceEntry entry{};
    entry.tick = clock_.tick();
    entry.levels = (written_ & kOutputMask) | inputs_.raw();
    entry.kind = kind;
    entry.token = token;
    entry.position_pulses = pulses_.positions();
    if (!io_->trace->push(entry)) ++trace_lost_;
}

}  // namespace psicarve::cycle
