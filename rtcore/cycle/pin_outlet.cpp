// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/pin_outlet.hpp"

namespace psicarve::cycle {

void PinOutlet::write() noexcept {
    pins_.write(pulses_->levels(), clock_->time_ns());
    if (pulses_->begun_pulses() == 0) return;
    if (tracer_.is_on()) tracer_.trace_pins(levels(), clock_->tick(), 0);
    port_->wait(pulse_ns_);
    pulses_->end_begun_pulses();
    pins_.write(pulses_->levels(), clock_->time_ns() + pulse_ns_);
    if (tracer_.is_on()) tracer_.trace_pins(levels(), clock_->tick(), pulse_ns_);
}

void PinOutlet::end_pulses(TickClock::Instant at) noexcept {
    pulses_->end_pulses(at.tick);
    pins_.end_pulses(at.time_ns);
    if (tracer_.is_on()) tracer_.trace_pins(levels(), at.tick, 0);
}

void PinOutlet::trace() noexcept {
    tracer_.trace_change(levels(), clock_->tick());
    if (tracer_.has_new_position()) tracer_.trace_position(levels(), clock_->tick(), pulses_->positions());
}

}  // namespace psicarve::cycle
