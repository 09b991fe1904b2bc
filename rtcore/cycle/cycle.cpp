// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"
#include "rtcore/cycle/index_check.hpp"

namespace psicarve::cycle {

Cycle::Cycle(const CycleConfig& config, port::Port& port, CycleIo& io) noexcept
    : config_(config),
      port_(&port),
      io_(&io),
      clock_(config.period_ns),
      pulses_(config),
      inputs_(config),
      motion_(config_, io, pulses_, inputs_),
      outlet_(config_, port, io, pulses_, inputs_, clock_),
      reporter_(io, clock_, pulses_, inputs_),
      publisher_(io, config.sample_ticks),
      program_(config.interpolation_ns(), config.period_ns) {
    publisher_.publish(sample());
}

void Cycle::tick() noexcept {
    if (config_.has_two_timers()) return tick_by_two_timers();
    take_in();
    go_on_with_motion();
    put_out();
    clock_.advance(1);
}

void Cycle::take_in() noexcept {
    // The machine's answer to the last tick's pulses comes before this tick's: so positions and levels agree.
    const SignalWord raw = port_->read_inputs(clock_.time_ns());
    if (inputs_.needs(raw)) take_inputs(raw);
    pulses_.begin_tick(clock_.tick());
    if ((inputs_.accepted() & kLimitMask) != 0) check_limits();
    take_urgent_words();
    for (RequestRing* ring : {&io_->requests, &io_->replayed_requests}) take_next_request(*ring);
    if (move_.has_lease()) check_lease();
    if (state_ == MachineState::testing) go_on_with_trial();
}

// It rests in an alarm: what hangs on it cuts the power then.
void Cycle::toggle_charge_pump() noexcept {
    const bool rests = state_ == MachineState::alarm || !port_->is_healthy();
    if (rests) {
        outlet_.rest_charge_pump();
    } else {
        outlet_.toggle_charge_pump();
    }
}

void Cycle::put_out() noexcept {
    if (config_.has_charge_pump) toggle_charge_pump();
    if (outlet_.has_change()) write_port();
    // What failed once may not have taken the alarm's safe state.
    if (state_ == MachineState::alarm && !port_->is_healthy() && outlet_.try_safe_state())
        publisher_.ask(clock_.tick());
    outlet_.trace();
    if (publisher_.is_due(clock_.tick())) publish();
}

void Cycle::advance_missed(std::uint64_t ticks) noexcept {
    clock_.count_missed(ticks);
    reporter_.report_gap(ticks, motion_.coasting().longest_harmless_gap(clock_.tick()));
    const auto count = static_cast<std::int64_t>(ticks);
    check_gap((count + 1) * config_.step_ticks());
    clock_.advance(count * config_.step_ticks());
}

void Cycle::take_inputs(SignalWord raw) noexcept {
    // A port that failed shows every input tripped: that is no limit and no emergency stop.
    if (!port_->is_healthy()) return raise_alarm(AlarmCause::port_error, kNoAxis);
    const SignalWord before = inputs_.raw();
    inputs_.take(raw, clock_.tick(), pulses_.positions());
    limits_.note(inputs_.accepted() | inputs_.raw());
    const SignalWord changed = before ^ inputs_.raw();
    for (std::size_t k = 0; changed != 0 && k <= kAxisCount; ++k) {
        const SignalWord input = bit_of(Signal::r1_limit) << k;
        if ((changed & input) == 0) continue;
        reporter_.report(RecordKind::input_edge, (inputs_.raw() & input) != 0 ? 1 : 0,
                         k < kAxisCount ? static_cast<std::uint8_t>(k) : kNoAxis);
    }
    if ((changed & kIndexBit) != 0) take_index();
    if ((inputs_.raw() & kEstopBit) != 0 && state_ != MachineState::alarm) {
        raise_alarm(AlarmCause::emergency_stop, kNoAxis);
    }
}

void Cycle::check_limits() noexcept {
    constexpr std::uint32_t kAtHand =
        state_bit(MachineState::off) | state_bit(MachineState::alarm) | state_bit(MachineState::testing);
    if ((kAtHand >> static_cast<unsigned>(state_) & 1U) != 0) return;
    const std::uint8_t axis = limits_.alarming_axis(inputs_.accepted(), motion_.homing_axis());
    if (axis != kNoAxis) raise_alarm(AlarmCause::limit, axis);
}

void Cycle::take_index() noexcept {
    const bool is_positive = pulses_.is_positive(kPsi);
    const bool is_tripped = inputs_.is_tripped(kPsi);
    if (!config_.has_index || !homed_.has(kPsi) || is_positive != is_tripped) return;
    const IndexCheck index = check_index(config_, pulses_.positions()[kPsi], is_positive);
    if (index.is_right && program_.is_on()) return;
    if (index.is_right) return job_.note_index(motion_.progress().layer());
    raise_alarm(AlarmCause::steps_lost, static_cast<std::uint8_t>(kPsi), index.seen_pulses - index.off_pulses,
                index.seen_pulses);
}

void Cycle::take_urgent_words() noexcept {
    take_stops();
    watch_supervisor();
    if (io_->urgent.failures.load(std::memory_order_relaxed) != 0) take_failures();
}

void Cycle::take_stops() noexcept {
    if (stops_.take_emergency_stop(io_->urgent)) {
        reporter_.report(RecordKind::emergency_stop, 0);
        raise_alarm(AlarmCause::emergency_stop, kNoAxis);
    }
    if (stops_.take_stop(io_->urgent)) {
        reporter_.report(RecordKind::stop, 0);
        stop();
    }
}

// A silent supervisor hands on no request to hold, and ends no jog: what moves or turns is not left alone.
void Cycle::watch_supervisor() noexcept {
    const std::uint64_t rounds = io_->urgent.rounds.load(std::memory_order_relaxed);
    if (!supervisor_.falls_silent(rounds, config_.step_ticks() * config_.period_ns)) return;
    const bool is_switched_on = (pulses_.levels() & (bit_of(Signal::spindle) | kSwitchedMask)) != 0;
    if (is_at_rest(state_) && !is_switched_on) return;
    io_->urgent.failures.fetch_or(failure_bits(AlarmCause::supervisor_stalled), std::memory_order_relaxed);
}

void Cycle::take_failures() noexcept {
    const std::uint64_t failures = io_->urgent.failures.exchange(0, std::memory_order_acq_rel);
    for (std::uint8_t cause = 0; cause < kAlarmCauseCount; ++cause) {
        if ((failures >> cause & 1U) == 0) continue;
        Request request{};
        request.kind = RequestKind::fail;
        request.axis = static_cast<std::uint8_t>(failures >> kLostAxesShift);
        request.value = cause;
        take_request(request);
    }
}

void Cycle::take_next_request(RequestRing& ring) noexcept {
    const Request* const next = ring.front();
    if (next == nullptr) return;
    const Request request = *next;
    ring.pop();
    take_request(request);
}

void Cycle::after_step(Motion::Progress progress) noexcept {
    using E = Executor;
    if ((progress & E::kGroupStarted) != 0 && carves_job()) job_.note_group(clock_.tick());
    if ((progress & E::kPoint) != 0) job_.note_points(motion_.progress().points_reached(), clock_.tick());
    if ((progress & (E::kLatched | E::kDefined)) != 0) note_new_position((progress & E::kLatched) != 0);
    if ((progress & E::kNotFound) != 0) raise_alarm(AlarmCause::home_failed, motion_.latch_axis());
    if ((progress & E::kStarved) != 0) raise_alarm(AlarmCause::plan_starved, kNoAxis);
    if ((progress & E::kAtRest) != 0) came_to_rest();
    if ((progress & Motion::kLifted) != 0) apply(MachineEvent::at_rest);
    if ((progress & E::kHalted) != 0) halt_program(motion_.halt());
    if ((progress & E::kLineDone) != 0) line_done();
    if ((progress & E::kProgramEnd) != 0) program_done();
}

// Homing defines positions, by a sensor or (home = none) as they are; positioning drops whole turns of psi.
void Cycle::note_new_position(bool by_sensor) noexcept {
    const std::uint8_t axis = motion_.latch_axis();
    if (by_sensor || state_ == MachineState::homing) {
        homed_.add(axis);
        reporter_.report(RecordKind::home_latch, 0, axis, motion_.latch_correction());
    }
    outlet_.note_new_position();
}

void Cycle::write_port() noexcept {
    outlet_.write();
    if (!port_->is_healthy()) raise_alarm(AlarmCause::port_error, kNoAxis);
}

void Cycle::publish() noexcept {
    if (!port_->is_healthy()) raise_alarm(AlarmCause::port_error, kNoAxis);
    if (carves_program()) tell_program_line();
    publisher_.publish_positions(pulses_.positions(), clock_.tick());
    publisher_.publish(sample());
}

void Cycle::shut_down() noexcept {
    drop_plan();
    pulses_.make_safe();
    outlet_.rest_charge_pump();
    write_port();
}

}  // namespace psicarve::cycle
