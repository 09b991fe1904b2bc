// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "rtcore/cycle/alarm.hpp"
#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/cycle/homed_axes.hpp"
#include "rtcore/cycle/inputs.hpp"
#include "rtcore/cycle/job_run.hpp"
#include "rtcore/cycle/layer_range.hpp"
#include "rtcore/cycle/leased_move.hpp"
#include "rtcore/cycle/limit_watch.hpp"
#include "rtcore/cycle/motion.hpp"
#include "rtcore/cycle/pin_outlet.hpp"
#include "rtcore/cycle/pin_trial.hpp"
#include "rtcore/cycle/program_run.hpp"
#include "rtcore/cycle/publisher.hpp"
#include "rtcore/cycle/pulse_stage.hpp"
#include "rtcore/cycle/reporter.hpp"
#include "rtcore/cycle/stop_words.hpp"
#include "rtcore/cycle/supervisor_watch.hpp"
#include "rtcore/cycle/tick_clock.hpp"
#include "rtcore/port/port.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/machine/recorded_gaps.hpp"

namespace psicarve::cycle {

/// A set of machine states, one bit each.
constexpr std::uint32_t state_bit(MachineState state) noexcept {
    return std::uint32_t{1} << static_cast<unsigned>(state);
}
/// The states in which motion blocks are executed.
inline constexpr std::uint32_t kExecutingStates =
    state_bit(MachineState::homing) | state_bit(MachineState::moving) | state_bit(MachineState::positioning) |
    state_bit(MachineState::carving) | state_bit(MachineState::holding) | state_bit(MachineState::finishing) |
    state_bit(MachineState::stopping) | state_bit(MachineState::backing_off);

/// One tick of the machine: read inputs -> limits, emergency stop, index -> requests -> interpolate -> write
/// outputs. Holds the one MachineState, and decides: what each part of it is for stands in that part's
/// header, and no part knows of states. All methods belong to the one thread that ticks; all others talk
/// through CycleIo. Port and io outlive it. RT: yes, every method, after construction.
///
/// Twenty-one members: its parts, each of which other parts or the states ask, and what is its own, the
/// state.
class Cycle {
public:
    /// Writes the safe state to the port at time 0.
    Cycle(const CycleConfig& config, port::Port& port, CycleIo& io) noexcept;

    /// Schedule two-timer: all that falls into one period of inputs and pulses.
    void tick() noexcept;

    // Schedule two-timer, each half by its own thread; the callers let in one at a time.
    /// The first half: inputs, limits, requests, and the pulses that wait go out.
    void take_inputs_and_step() noexcept;
    /// Whether pulses began that end step_high_ticks later.
    bool has_pulses_to_end() const noexcept { return has_pulses_to_end_; }
    void end_pulses() noexcept;
    /// The second half: one step of the interpolation. Its pulses wait for the first.
    void interpolate() noexcept;
    /// So many steps of the interpolation did not come: time that is not made up for.
    void advance_missed_interpolation(std::uint64_t steps) noexcept;

    /// So many ticks' times have passed without a tick: they are counted and never made up for. Call before
    /// the tick() that comes late.
    void advance_missed(std::uint64_t ticks) noexcept;
    /// The end of the core's work, whatever the state: drives and spindle off.
    void shut_down() noexcept;

    /// The number of the next tick.
    std::uint64_t next_tick() const noexcept { return clock_.tick(); }
    MachineState state() const noexcept { return state_; }
    const PulseStage& pulses() const noexcept { return pulses_; }
    /// Something was switched that the pins do not show yet: with two timers they do at the next tick.
    bool is_switching() const noexcept { return outlet_.has_change(); }
    /// On hold, or on their way there or back: the heads are off the path.
    bool are_heads_lifted() const noexcept { return motion_.are_heads_lifted(); }
    /// A program runs, and nothing is left to do before its next block comes, or it may slow down without.
    bool awaits_blocks() const noexcept {
        return carves_program() && (motion_.has_run_out() || motion_.runs_short());
    }
    /// Takes what is queued of a plan that was dropped out at once. Not in a tick: before it.
    void drop_overtaken_blocks() noexcept { motion_.drop_overtaken_blocks(); }
    /// What the sample record shows when it is renewed.
    Sample sample() const noexcept;

    /// For a replay only, before the first tick: every axis counts as homed and stands here; directions as in
    /// `levels`, unless that is 0, with so much of their gaps to cross that way.
    void assume_homed(const std::array<std::int64_t, kAxisCount>& position_pulses, SignalWord levels = 0,
                      const GapsLeft& left_pulses = {}) noexcept;

private:
    // cycle.cpp: the tick
    void take_in() noexcept;
    void put_out() noexcept;
    void toggle_charge_pump() noexcept;
    void take_inputs(SignalWord raw) noexcept;
    void check_limits() noexcept;
    void take_index() noexcept;
    void take_urgent_words() noexcept;
    void take_stops() noexcept;
    void take_failures() noexcept;
    void watch_supervisor() noexcept;
    void take_next_request(RequestRing& ring) noexcept;
    void after_step(Motion::Progress progress) noexcept;
    void note_new_position(bool by_sensor) noexcept;
    void write_port() noexcept;
    void publish() noexcept;
    // cycle_two_timer.cpp
    void tick_by_two_timers() noexcept;
    // cycle_states.cpp: states, and the plans that they need
    bool apply(MachineEvent event) noexcept;
    void enter(MachineState state) noexcept;
    void program_done() noexcept;
    void came_to_rest() noexcept;
    void go_on_with_motion() noexcept;
    bool lifts_on_hold() const noexcept {
        const bool is_dry = job_.is_dry() && !program_.is_on();
        return !is_dry && (config_.lift_pulses[0] > 0 || config_.lift_pulses[1] > 0);
    }
    void end_move(MoveEnd end) noexcept;
    void end_after_stop() noexcept;
    void stop() noexcept;
    void request_plan(PlanKind kind, std::uint8_t axis = kNoAxis,
                      const MotionOrder* order = nullptr) noexcept;
    void drop_plan() noexcept;
    /// Override is of the carving; positioning, homing and retraction go as planned.
    double feed_ratio(bool is_carving) const noexcept { return is_carving ? job_.feed_ratio() : 1.0; }
    // cycle_alarms.cpp: into an alarm, and out of it
    void fail_controlled(AlarmCause cause) noexcept;
    void raise_alarm(AlarmCause cause, std::uint8_t axis, std::int64_t expected_pulses = 0,
                     std::int64_t seen_pulses = 0) noexcept;
    std::uint32_t moving_axes() const noexcept;
    void check_gap(std::int64_t gap_ticks) noexcept;
    void come_back(std::uint32_t lost_axes) noexcept;
    Refusal reset_alarm() noexcept;
    Refusal back_off(std::uint8_t axis) noexcept;
    // cycle_requests.cpp: what the supervisor asks
    void take_request(const Request& request) noexcept;
    bool is_overtaken(const Request& request) noexcept;
    Verdict judge(const Request& request) noexcept;
    Refusal start_home(std::uint64_t axes) noexcept;
    Refusal reset_height() noexcept;
    void begin_homing(MachineEvent event, std::uint32_t axes) noexcept;
    Refusal start_job(LayerRange layers) noexcept;
    Refusal start_interpolation() noexcept;
    Refusal hold() noexcept;
    Refusal resume() noexcept;
    Refusal load_job(const Request& request) noexcept;
    Refusal take_override(std::uint64_t percent) noexcept;
    Refusal take_rapid_override(std::uint64_t percent) noexcept;
    Refusal record(const Request& request) noexcept;
    // cycle_moves.cpp: jogs, moves, the spindle by hand
    Verdict start_move(const Request& request) noexcept;
    void check_lease() noexcept;
    void end_jog(MoveEnd end) noexcept;
    Refusal switch_spindle(bool on) noexcept;
    // cycle_program.cpp: a program of motion records
    Refusal start_program(const Request& request) noexcept;
    Refusal switch_stops(RequestKind kind, bool is_on) noexcept;
    void line_done() noexcept;
    void watch_supply() noexcept;
    void halt_program(ProgramHold hold) noexcept;
    void rest_in_program() noexcept;
    void go_on_when_fed() noexcept;
    bool holds_starved_program() noexcept;
    void program_of_records_done() noexcept;
    void note_program_line() noexcept;
    void tell_program(ProgramEvent event, std::uint8_t detail = 0) noexcept;
    void tell_starvations() noexcept;
    void tell_program_line() noexcept;
    void tell_program_of(MachineState left, MachineState entered) noexcept;
    ProgramEnding ending_in(MachineState entered) const noexcept;
    ProgramStatus program_status() const noexcept;
    // cycle_trial.cpp: the outputs by hand
    Refusal try_pin(const Request& request) noexcept;
    void go_on_with_trial() noexcept;
    void end_trial(MoveEnd end) noexcept;
    Refusal drives_off() noexcept;

    bool carves_job() const noexcept { return state_ == MachineState::carving && !program_.is_on(); }
    bool carves_program() const noexcept { return state_ == MachineState::carving && program_.is_on(); }
    /// Into a starving program's rest and out of it: what is told of that is how often it was.
    bool starves_into(MachineState state) const noexcept {
        return program_.is_on() && program_.is_starved() &&
               (state == MachineState::holding || state == MachineState::held ||
                state == MachineState::carving);
    }
    bool executes() const noexcept { return (kExecutingStates >> static_cast<unsigned>(state_) & 1U) != 0; }
    bool cause_remains() const noexcept {
        return ((inputs_.raw() | inputs_.accepted()) & (kLimitMask | kEstopBit)) != 0;
    }

    CycleConfig config_;
    port::Port* port_;
    CycleIo* io_;
    TickClock clock_;
    PulseStage pulses_;
    Inputs inputs_;
    Motion motion_;
    PinOutlet outlet_;
    Reporter reporter_;
    Publisher publisher_;

    MachineState state_ = MachineState::off;
    Alarm alarm_;
    HomedAxes homed_;
    LimitWatch limits_;
    JobRun job_;
    ProgramRun program_;
    LeasedMove move_;
    PinTrial trial_;
    StopWords stops_;
    SupervisorWatch supervisor_;
    bool has_pulses_to_end_ = false;
};

}  // namespace psicarve::cycle
