// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"

namespace psicarve::cycle {

Sample Cycle::sample() const noexcept {
    Sample sample{};
    sample.tick = clock_.tick();
    sample.state = state_;
    sample.alarm_cause = alarm_.cause();
    sample.alarm_axis = alarm_.axis();
    sample.homed_mask = homed_.mask();
    sample.signals = pulses_.levels() | inputs_.raw();
    // Samples come in step with its toggling: what they show is whether it does.
    const bool toggles = config_.has_charge_pump && state_ != MachineState::alarm && port_->is_healthy();
    if (toggles) sample.signals |= kChargePumpBit;
    sample.is_port_silent = port_->is_silent() ? 1 : 0;
    sample.signals |= port_->stuck_outputs();
    sample.move_end = move_.ended();
    sample.position_pulses = pulses_.positions();
    sample.emitted_pulses = pulses_.emitted();
    sample.layer = motion_.progress().layer();
    sample.point = motion_.progress().point();
    sample.points_done = motion_.progress().points_reached();
    job_.show_in(sample);
    if (program_.is_on()) sample.is_dry = 0;
    sample.missed_ticks = clock_.missed();
    sample.waited_ticks = motion_.progress().waited_ticks();
    sample.trace_lost = outlet_.trace_lost();
    sample.reports_lost = reporter_.lost();
    sample.increments_lost = publisher_.increments_lost();
    sample.program = program_status();
    return sample;
}

}  // namespace psicarve::cycle
