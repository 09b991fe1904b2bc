// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/dual_head_dda.hpp"
#include "rtcore/cycle/fine_move.hpp"
#include "rtcore/cycle/inputs.hpp"
#include "rtcore/cycle/linear_profile.hpp"
#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/path_law.hpp"
#include "rtcore/cycle/pulse_stage.hpp"

namespace psicarve::cycle {

/// Walks the motion blocks. Lines and path segments: at most one DDA iteration a tick, emitted whole once
/// every axis in it may step. Moves: fine interpolation, each axis' pulse as it falls due.
///
///     line: linear profile -+-> an iteration is due -> DDA says which axes --+
///     path: path law -------+                                               +-> pulse stage says when ->
///     pins move: coarse interpolator -> increments -> fine DDA -------------------+
///
/// While the pins keep a pulse waiting, the time of a line or a move stands still; that of a path runs on
/// until a second iteration is due, so that a short wait is made up for and a burst never comes. Knows
/// nothing of machine states. Where a block turns an axis round whose screw has backlash, the motors first
/// cross the gap, from rest to rest, while no tip moves. The config outlives it. RT: yes.
class Executor {
public:
    /// What happened in a tick, as bits.
    using Progress = std::uint32_t;
    static constexpr Progress kNothing = 0;
    static constexpr Progress kGroupStarted = 1;  ///< a motion begins: its time runs from this tick on
    static constexpr Progress kPoint = 2;         ///< a point was reached: layer(), point()
    static constexpr Progress kLatched = 4;       ///< an axis' position was defined anew: latch_axis()
    static constexpr Progress kDefined = 8;       ///< the same, without a sensor
    static constexpr Progress kAtRest = 16;       ///< slowed down as asked; motion stands on an iteration
    static constexpr Progress kProgramEnd = 32;
    static constexpr Progress kNotFound = 64;  ///< the sensor of latch_axis() did not do what it should
    static constexpr Progress kStarved = 128;  ///< a group's next block is not there, or is none that ends

    Executor(const CycleConfig& config, BlockRing& blocks, PulseStage& pulses, const Inputs& inputs) noexcept
        : config_(&config),
          blocks_(&blocks),
          pulses_(&pulses),
          inputs_(&inputs),
          period_s_(static_cast<double>(config.interpolation_ns()) * 1e-9),
          law_(period_s_) {}

    Progress step(std::uint64_t tick) noexcept {
        if (in_motion_) return advance(tick);
        if (pulses_->is_gate_shut()) return kNothing;
        if (slowing_) return kAtRest;
        return next_block(tick);
    }

    /// From the next step on: slow down and come to rest on the path / go on.
    void slow_down() noexcept {
        slowing_ = true;
        law_.aim(0.0);
    }
    void go_on() noexcept {
        slowing_ = false;
        law_.aim(feed_ratio_);
    }
    /// The heads have been elsewhere and are back: as go_on(), with the path's directions.
    void go_on_after_lift(std::uint64_t tick) noexcept;
    /// So much of the planned feed from the next step on, 0.1 to 2. Paths only know more than 1: lines and
    /// moves keep to their plan then.
    void set_feed_ratio(double feed_ratio) noexcept;
    /// From the next block on these axes (bit by axis) stand still: the pulses that they would have are not
    /// sent, all else is as it would be. None after reset().
    void set_still_axes(std::uint32_t axes) noexcept { still_axes_ = axes; }
    /// Forgets the motion at hand; blocks of other epochs are dropped from now on.
    void reset(std::uint32_t epoch) noexcept;

    /// Axes (bit by axis) with a way to go in the block at hand.
    std::uint32_t axes_in_motion() const noexcept;
    /// The axis whose sensor may trip without an alarm, or kNoAxis: from its first homing block until another
    /// axis' block or the program's end, so that no tick between two blocks sees it as a limit.
    std::uint8_t homing_axis() const noexcept { return homing_axis_; }

    std::uint32_t layer() const noexcept { return layer_; }
    std::uint32_t point() const noexcept { return point_; }
    std::uint64_t points_reached() const noexcept { return points_reached_; }
    /// Ticks in which an iteration was due and the pins kept it waiting, since clear_points().
    std::uint64_t waited_ticks() const noexcept { return waited_ticks_; }
    /// The next run's points count on from so many.
    void clear_points(std::uint64_t points_before = 0) noexcept;
    std::uint8_t latch_axis() const noexcept { return block_.axis; }
    /// How far the last latch or definition moved the count [pulses].
    std::int64_t latch_correction() const noexcept { return latch_correction_; }

private:
    Progress advance(std::uint64_t tick) noexcept;
    Progress advance_move(std::uint64_t tick, bool must_slow) noexcept;
    Progress advance_path(std::uint64_t tick) noexcept;
    void step_fine(std::uint64_t tick, bool must_slow) noexcept;
    void start_fine() noexcept;
    // executor_take_up.cpp
    void turn_axes(std::uint64_t tick) noexcept;
    void lengthen_by_take_up() noexcept;
    bool begin_take_up(std::uint64_t tick) noexcept;
    Progress advance_take_up(std::uint64_t tick) noexcept;
    bool is_iteration_due() const noexcept;
    bool is_segment_done() const noexcept;
    Progress begin_path(std::uint64_t tick) noexcept;
    void begin_segment(std::uint64_t tick) noexcept;
    void start_dda() noexcept;
    void turn_idle_axes(std::uint64_t tick) noexcept;
    void expect_iteration(double number) noexcept;
    bool is_slowest() const noexcept;
    void rest() noexcept;
    Progress emit(std::uint64_t tick) noexcept;
    Progress end_of_way(std::uint64_t tick) noexcept;
    Progress end_of_line(std::uint64_t tick) noexcept;
    bool take_next_of_group() noexcept;
    Progress next_block(std::uint64_t tick) noexcept;
    Progress begin(std::uint64_t tick) noexcept;
    Progress begin_motion(std::uint64_t tick) noexcept;
    Progress reached() noexcept;
    Progress define(std::int64_t correction, Progress what) noexcept;
    bool drop_foreign_blocks() noexcept;
    Progress watch_sensor() noexcept;
    bool must_wait_for_sensor() const noexcept;

    const CycleConfig* config_;
    BlockRing* blocks_;
    PulseStage* pulses_;
    const Inputs* inputs_;
    double period_s_;

    MotionBlock block_{};
    DualHeadDda dda_;             ///< lines, path segments
    LinearProfile profile_;       ///< lines
    PathLaw law_;                 ///< path segments
    FineMove fine_;               ///< moves, and taking up backlash before any block
    double iteration_ = 0.0;      ///< path: the number of the next iteration in its segment
    double iteration_way_ = 0.0;  ///< path: from one iteration to the next
    double due_way_ = 0.0;        ///< path: where the next iteration is due
    double feed_ratio_ = 1.0;
    std::uint32_t epoch_ = 0;
    std::uint32_t still_axes_ = 0;
    std::array<std::int64_t, kAxisCount> take_up_way_{};
    std::uint32_t group_blocks_left_ = 0;
    std::uint32_t next_axes_ = 0;  ///< of the iteration that is due; 0: not made yet
    bool in_motion_ = false;
    bool is_taking_up_ = false;  ///< the block at hand has not begun: its axes cross their gaps first
    bool slowing_ = false;
    bool sensor_done_ = false;  ///< the condition of `until` came true
    bool index_before_ = false;
    std::uint8_t homing_axis_ = 255;
    std::int64_t dwell_left_ = 0;
    std::int64_t latch_correction_ = 0;
    std::uint32_t layer_ = 0;
    std::uint32_t point_ = 0;
    std::uint64_t points_reached_ = 0;
    std::uint64_t waited_ticks_ = 0;
};

}  // namespace psicarve::cycle
