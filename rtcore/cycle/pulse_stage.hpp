// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/tips.hpp"
#include "shared/machine/recorded_gaps.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// The pins' levels and the positions they stand for. Step pulses over whole ticks, or (step_high_ticks 0)
/// begun and ended in one by the tick itself, who asks for begun_pulses() and says end_begun_pulses():
///
///     dir   ____/~~~~~~~~~~~~~~~~~~~~\____
///     step  _________/~~~~\_________/~~~~\     the rising edge is the pulse
///               |-1--|-2--|----3----|
///                    |---4---| then dir may change
///     1 dir_setup_ticks   2 step_high_ticks   3 step_low_ticks   4 dir_hold_ticks, each at least 1
///
/// Schedule two-timer: an iteration that steps waits here until the ticks of inputs and pulses let it out,
/// and the next waits for it. Directions turn at such ticks, too.
///
/// RT: yes.
class PulseStage {
public:
    explicit PulseStage(const CycleConfig& config) noexcept
        : high_ticks_(ticks(config.step_high_ticks)),
          low_ticks_(ticks(config.step_low_ticks)),
          setup_ticks_(ticks(config.dir_setup_ticks)),
          hold_ticks_(ticks(config.dir_hold_ticks)),
          has_gate_(config.has_two_timers()),
          tips_(config) {}

    /// First thing of a tick: pulses end, directions that waited for their hold time turn.
    void begin_tick(std::uint64_t tick) noexcept {
        if ((levels_ & kStepMask) != 0) end_pulses(tick);
        if (dir_waiting_ != 0) turn_directions(tick);
    }

    /// The next pulses of these axes go the way of their delta's sign (0: as it is); the pins follow as soon
    /// as hold allows.
    void want_directions(const std::array<std::int64_t, kAxisCount>& delta_pulses,
                         std::uint64_t tick) noexcept;

    /// No pulse waits for a turn of direction or at the gate any more.
    void forget_waiting() noexcept {
        dir_waiting_ = 0;
        at_gate_ = 0;
    }

    /// Whether all these axes (bit by axis) may step at this tick.
    bool may_step(std::uint32_t axes, std::uint64_t tick) const noexcept {
        if ((dir_waiting_ & axes) != 0) return false;
        return has_gate_ ? at_gate_ == 0 : is_time_to_step(axes, tick);
    }
    /// The same for an axis that takes no heed of the others.
    bool may_step_apart(std::uint32_t axis, std::uint64_t tick) const noexcept {
        return has_gate_ ? ((dir_waiting_ | at_gate_) & axis) == 0 : may_step(axis, tick);
    }

    /// One pulse of each of these axes begins, or waits at the gate. Requires may_step().
    void step(std::uint32_t axes, std::uint64_t tick) noexcept {
        if (has_gate_) {
            at_gate_ |= axes;
        } else {
            begin_pulses(axes, tick);
        }
    }
    /// Two-timer: a tick of inputs and pulses lets out what waits, when the pins' times allow. True when
    /// pulses began.
    bool open_gate(std::uint64_t tick) noexcept {
        if (at_gate_ == 0 || !is_time_to_step(at_gate_, tick)) return false;
        begin_pulses(at_gate_, tick);
        at_gate_ = 0;
        return true;
    }
    bool is_gate_shut() const noexcept { return at_gate_ != 0; }
    /// Pulses over whole ticks whose time is over end.
    void end_pulses(std::uint64_t tick) noexcept {
        if (high_ticks_ == 1) {
            levels_ &= ~kStepMask;
            return;
        }
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((levels_ >> k & 1U) != 0 && tick >= last_step_[k] + high_ticks_) {
                levels_ &= ~(SignalWord{1} << k);
            }
        }
    }
    /// Pulses that end in the tick in which they began.
    std::uint32_t begun_pulses() const noexcept { return begun_; }
    void end_begun_pulses() noexcept {
        levels_ &= ~SignalWord{begun_};
        begun_ = 0;
    }

    /// Steps low, drives, spindle and switched outputs off, at once.
    void make_safe() noexcept {
        levels_ &= kDirMask;
        forget_waiting();
        begun_ = 0;
    }
    /// By hand: these levels and no others, until the next. Nothing is counted.
    void force(SignalWord levels) noexcept {
        levels_ = levels & kOutputMask;
        forget_waiting();
        begun_ = 0;
    }
    /// Before the first tick: where the direction pins stood when the machine came to its place, and how much
    /// of their gaps the screws had still to cross that way.
    void assume_directions(SignalWord levels, const GapsLeft& left_pulses) noexcept {
        levels_ = (levels_ & ~kDirMask) | (levels & kDirMask);
        for (std::size_t k = 0; k < kAxisCount; ++k) tips_.rest_before(k, is_positive(k), left_pulses[k]);
    }
    void set_enables(std::uint32_t axes, std::uint64_t tick) noexcept;
    void set_spindle(bool on) noexcept {
        levels_ = on ? levels_ | bit_of(Signal::spindle) : levels_ & ~bit_of(Signal::spindle);
    }
    void switch_outputs(SwitchedOutputs on, SwitchedOutputs off) noexcept {
        levels_ = (levels_ & ~levels_of(off)) | levels_of(on);
    }
    /// Spindle, coolant and digital outputs.
    void end_switches() noexcept {
        set_spindle(false);
        switch_outputs(0, kAllSwitchedOutputs);
    }

    SignalWord levels() const noexcept { return levels_; }
    /// Of the tips: pulses that only cross a screw's gap do not count.
    const std::array<std::int64_t, kAxisCount>& positions() const noexcept { return tips_.positions(); }
    const std::array<std::uint64_t, kAxisCount>& emitted() const noexcept { return emitted_; }
    void clear_emitted() noexcept { emitted_.fill(0); }
    void set_position(std::size_t axis, std::int64_t position_pulses) noexcept {
        tips_.set_position(axis, position_pulses);
    }
    /// Of each screw's gap, downwards.
    const std::array<std::int64_t, kAxisCount>& crossed_pulses() const noexcept {
        return tips_.crossed_pulses();
    }
    bool has_backlash() const noexcept { return tips_.has_backlash(); }
    /// Pulses upwards (or down) that go by before the tip follows.
    std::int64_t take_up_pulses(std::size_t axis, bool up) const noexcept {
        return tips_.take_up_pulses(axis, up);
    }
    /// The same, each the way its direction pin shows.
    GapsLeft gaps_left() const noexcept {
        GapsLeft left{};
        for (std::size_t k = 0; k < kAxisCount; ++k) left[k] = take_up_pulses(k, is_positive(k));
        return left;
    }
    /// Has it stepped within the last `ticks` ticks?
    bool stepped_within(std::size_t axis, std::int64_t within_ticks, std::uint64_t tick) const noexcept {
        return emitted_ever(axis) && tick - last_step_[axis] <= ticks(within_ticks);
    }
    /// The direction pin's level: is it positive?
    bool is_positive(std::size_t axis) const noexcept { return (levels_ >> (kDirShift + axis) & 1U) != 0; }

private:
    static constexpr std::size_t kDirShift = index_of(Signal::r1_dir);
    static constexpr std::size_t kEnableShift = index_of(Signal::r1_enable);
    static constexpr std::uint64_t kNever = ~std::uint64_t{0};
    static std::uint64_t ticks(std::int64_t count) noexcept { return static_cast<std::uint64_t>(count); }
    bool emitted_ever(std::size_t axis) const noexcept { return last_step_[axis] != kNever; }
    bool is_time_to_step(std::uint32_t axes, std::uint64_t tick) const noexcept {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((axes >> k & 1U) != 0 && tick < step_from_[k]) return false;
        }
        return true;
    }
    void begin_pulses(std::uint32_t axes, std::uint64_t tick) noexcept {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((axes >> k & 1U) == 0) continue;
            tips_.count_pulse(k, (levels_ >> (kDirShift + k) & 1U) != 0);
            ++emitted_[k];
            last_step_[k] = tick;
            step_from_[k] = tick + high_ticks_ + low_ticks_;
        }
        levels_ |= axes;
        if (high_ticks_ == 0) begun_ |= axes;
    }
    void turn_directions(std::uint64_t tick) noexcept;

    std::uint64_t high_ticks_;
    std::uint64_t low_ticks_;
    std::uint64_t setup_ticks_;
    std::uint64_t hold_ticks_;
    bool has_gate_;
    std::uint32_t at_gate_ = 0;  ///< two-timer: axes whose pulses are not out yet
    SignalWord levels_ = 0;
    std::uint32_t begun_ = 0;
    std::uint32_t dir_waiting_ = 0;  ///< axes whose direction pin must turn before they step
    std::array<std::uint64_t, kAxisCount> step_from_{};
    std::array<std::uint64_t, kAxisCount> last_step_{kNever, kNever, kNever, kNever};
    std::array<std::uint64_t, kAxisCount> emitted_{};
    Tips tips_;
};

}  // namespace psicarve::cycle
