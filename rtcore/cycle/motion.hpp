// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/coasting.hpp"
#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/cycle/executor.hpp"
#include "rtcore/cycle/head_lift.hpp"
#include "rtcore/cycle/homed_axes.hpp"
#include "rtcore/cycle/inputs.hpp"
#include "rtcore/cycle/pulse_stage.hpp"

namespace psicarve::cycle {

/// The plan at hand: asked of the planner, executed step by step, and left aside while the heads are out of
/// the cut on hold. What belongs to a dropped plan is never executed. Knows nothing of machine states.
/// Config, io, pulses and inputs outlive it. RT: yes.
class Motion {
public:
    /// As Executor's, and one more.
    using Progress = Executor::Progress;
    static constexpr Progress kLifted = 256;  ///< the heads are out of the cut, and rest

    Motion(const CycleConfig& config, CycleIo& io, PulseStage& pulses, const Inputs& inputs) noexcept
        : io_(&io),
          pulses_(&pulses),
          executor_(config, io.blocks, pulses, inputs),
          lift_(config, pulses),
          coasting_(config, pulses) {}

    /// One step of the interpolation, of the plan or of the heads' way out and back.
    Progress step(std::uint64_t tick) noexcept {
        return lift_.is_active() ? step_lift(tick) : executor_.step(tick);
    }

    /// Drops the plan at hand and asks for another. Epoch, positions and, of `still_axes`, what the executor
    /// needs are filled in here. False: the planner does not take it.
    bool ask(PlanRequest request, double feed_ratio, std::uint32_t still_axes) noexcept;
    void drop() noexcept;
    void set_feed_ratio(double feed_ratio) noexcept { executor_.set_feed_ratio(feed_ratio); }
    void set_rapid_ratio(double rapid_ratio) noexcept { executor_.set_rapid_ratio(rapid_ratio); }

    void rest_behind(std::uint8_t marks) noexcept { executor_.rest_behind(marks); }
    std::uint8_t rested_marks() const noexcept { return executor_.rested_marks(); }

    /// Hold and resume: to rest on the path; heads on their way turn round.
    void hold() noexcept;
    void resume() noexcept;
    /// At rest on the path, on hold: the heads go out of the cut.
    void lift() noexcept { lift_.lift(); }
    /// On hold, or on their way there or back: the heads are off the path.
    bool are_heads_lifted() const noexcept { return lift_.is_active(); }
    /// To rest for good, wherever that is.
    void slow_down() noexcept;

    /// Axes, bit by axis, with a way to go in the block at hand.
    std::uint32_t axes_on_their_way() const noexcept { return executor_.axes_in_motion(); }
    /// Rotors that may still turn.
    const Coasting& coasting() const noexcept { return coasting_; }

    /// As Executor has it, the heads' way out and back aside.
    bool is_under_way() const noexcept { return executor_.is_under_way(); }
    /// It rests, heads on the path, and nothing is queued that it could do next.
    bool has_run_out() const noexcept { return !lift_.is_active() && executor_.has_run_out(); }
    /// It may slow down for want of blocks.
    bool runs_short() const noexcept { return !lift_.is_active() && executor_.runs_short(); }
    void drop_overtaken_blocks() noexcept { executor_.drop_overtaken(); }
    bool has_block() const noexcept { return io_->blocks.front() != nullptr; }
    /// As Executor has them.
    std::uint64_t program_line() const noexcept { return executor_.program_line(); }
    std::uint64_t program_sequence() const noexcept { return executor_.program_sequence(); }
    ProgramHold halt() const noexcept { return executor_.halt(); }

    /// The next run's points count on from so many.
    void begin_points(std::uint64_t points_before) noexcept { executor_.clear_points(points_before); }
    const RunProgress& progress() const noexcept { return executor_.progress(); }
    /// As Executor says of the step in which they happened.
    std::uint8_t homing_axis() const noexcept { return executor_.homing_axis(); }
    std::uint8_t latch_axis() const noexcept { return executor_.latch_axis(); }
    std::int64_t latch_correction() const noexcept { return executor_.latch_correction(); }

private:
    Progress step_lift(std::uint64_t tick) noexcept;

    CycleIo* io_;
    PulseStage* pulses_;
    Executor executor_;
    HeadLift lift_;
    Coasting coasting_;
    std::uint32_t epoch_ = 0;
};

}  // namespace psicarve::cycle
