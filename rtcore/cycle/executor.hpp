// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "rtcore/cycle/block_feed.hpp"
#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/fine_move.hpp"
#include "rtcore/cycle/inputs.hpp"
#include "rtcore/cycle/iterations.hpp"
#include "rtcore/cycle/line_stop.hpp"
#include "rtcore/cycle/linear_profile.hpp"
#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/path_pace.hpp"
#include "rtcore/cycle/pulse_stage.hpp"
#include "rtcore/cycle/run_progress.hpp"
#include "rtcore/cycle/sensor_search.hpp"
#include "rtcore/cycle/take_up.hpp"

namespace psicarve::cycle {

/// Executes the motion blocks. Lines and path segments: at most one DDA iteration a tick, emitted whole once
/// every axis in it may step. Moves: fine interpolation, each axis' pulse as it falls due.
///
///                  +- line:  LinearProfile -+-> when due: Iterations, which axes -+
///     BlockFeed ---+- path:  PathPace ------+                                     +-> PulseStage -> pins
///                  +- move:  FineMove, SensorSearch: each axis by itself ---------+
///
/// Before any of them TakeUp may cross the gaps of screws. While the pins keep a pulse waiting, the time of a
/// line or a move stands still; that of a path runs on as PathPace says. Knows nothing of machine states. The
/// config outlives it. RT: yes. Twenty members: parts, and what of the motion at hand is none of theirs.
class Executor {
public:
    /// What happened in a tick, as bits.
    using Progress = std::uint32_t;
    static constexpr Progress kNothing = 0;
    static constexpr Progress kGroupStarted = 1;  ///< a motion begins: its time runs from this tick on
    static constexpr Progress kPoint = 2;         ///< a point was reached: progress()
    static constexpr Progress kLatched = 4;       ///< an axis' position was defined anew: latch_axis()
    static constexpr Progress kDefined = 8;       ///< the same, without a sensor
    static constexpr Progress kAtRest = 16;       ///< slowed down as asked; motion stands on an iteration
    static constexpr Progress kProgramEnd = 32;
    static constexpr Progress kNotFound = 64;    ///< the sensor of latch_axis() did not do what it should
    static constexpr Progress kStarved = 128;    ///< a group's next block is not there, or is none that ends
    static constexpr Progress kHalted = 512;     ///< a program's halt: halt() says why
    static constexpr Progress kLineDone = 1024;  ///< it rests behind a block with a wanted mark

    Executor(const CycleConfig& config, BlockRing& blocks, PulseStage& pulses, const Inputs& inputs) noexcept
        : pulses_(&pulses),
          period_s_(static_cast<double>(config.interpolation_ns()) * 1e-9),
          feed_(blocks),
          search_(inputs),
          pace_(period_s_),
          take_up_(config, pulses) {}

    Progress step(std::uint64_t tick) noexcept {
        if (in_motion_) return advance(tick);
        if (pulses_->is_gate_shut()) return kNothing;
        if (slowing_) return kAtRest;
        if (rested_at_mark()) return kLineDone;
        return feed_.take_first() ? begin(tick) : kNothing;
    }

    /// From the next step on: slow down and come to rest on the path / go on.
    void slow_down() noexcept {
        slowing_ = true;
        pace_.aim(0.0);
    }
    void go_on() noexcept {
        slowing_ = has_line_ended_;
        aim();
    }
    /// The heads have been elsewhere and are back: as go_on(), with the path's directions.
    void go_on_after_lift(std::uint64_t tick) noexcept;
    /// So much of the planned feed from the next step on, 0.1 to 2. Paths only know more than 1: lines and
    /// moves keep to their plan then.
    void set_feed_ratio(double feed_ratio) noexcept;
    /// So much of the speed of rapid ways from the next step on, 0.1 to 1.
    void set_rapid_ratio(double rapid_ratio) noexcept;
    /// From now on a program rests behind blocks with one of these marks, on its path: behind the first that
    /// a brake reaches. Halts that a plan has for others are passed over. 0: none.
    void rest_behind(std::uint8_t marks) noexcept;
    /// Of kLineDone: all marks of the block behind which it rests.
    std::uint8_t rested_marks() const noexcept { return rested_marks_; }
    /// From the next block on these axes (bit by axis) stand still: the pulses that they would have are not
    /// sent, all else is as it would be. None after reset().
    void set_still_axes(std::uint32_t axes) noexcept { still_axes_ = axes; }
    /// Forgets the motion at hand; blocks of other epochs are dropped from now on.
    void reset(std::uint32_t epoch) noexcept;

    /// Axes (bit by axis) with a way to go in the block at hand.
    std::uint32_t axes_in_motion() const noexcept;
    /// The axis that is being homed, as SensorSearch has it.
    std::uint8_t homing_axis() const noexcept { return search_.homing_axis(); }

    /// As BlockFeed has it.
    void drop_overtaken() noexcept { feed_.drop_overtaken(); }
    /// The motion at hand has begun and not ended, though it may rest on its way.
    bool is_under_way() const noexcept { return in_motion_; }
    /// It rests, and nothing is queued that it could do next.
    bool has_run_out() const noexcept { return !in_motion_ && feed_.has_run_out(); }
    /// It may slow down, or rest, because the next group is not queued.
    bool runs_short() const noexcept { return in_motion_ && feed_.goes_on() && !feed_.has_next_group(); }
    /// Of the block at hand; 0: it has none.
    std::uint64_t program_line() const noexcept { return cycle::program_line(block()); }
    std::uint64_t program_sequence() const noexcept { return cycle::program_sequence(block()); }
    /// After kHalted.
    ProgramHold halt() const noexcept { return block().halt; }

    const RunProgress& progress() const noexcept { return progress_; }
    /// The next run's points count on from so many.
    void clear_points(std::uint64_t points_before = 0) noexcept { progress_.begin(points_before); }
    std::uint8_t latch_axis() const noexcept { return block().axis; }
    /// How far the last latch or definition moved the count [pulses].
    std::int64_t latch_correction() const noexcept { return latch_correction_; }

private:
    // Segments may be shorter than a tick; so many of them end in one, the rest in the next.
    static constexpr std::uint32_t kSegmentsPerTick = 8;

    // executor.cpp: blocks of every kind
    Progress begin(std::uint64_t tick) noexcept;
    Progress begin_motion(std::uint64_t tick) noexcept;
    Progress advance(std::uint64_t tick) noexcept;
    Progress advance_take_up(std::uint64_t tick) noexcept;
    void turn_axes(std::uint64_t tick) noexcept;
    bool is_slowest() const noexcept;
    void rest() noexcept;
    void aim() noexcept;
    void enter_way() noexcept;
    double rapid_part() const noexcept;
    Progress reached() noexcept;
    Progress watch_sensor() noexcept;
    Progress define(std::int64_t correction, Progress what) noexcept;
    // executor_line.cpp: lines and moves
    bool start_line() noexcept;
    bool start_move() noexcept;
    Progress advance_line(std::uint64_t tick, bool must_slow) noexcept;
    Progress advance_move(std::uint64_t tick, bool must_slow) noexcept;
    Progress end_of_way(std::uint64_t tick) noexcept;
    Progress end_of_line(std::uint64_t tick) noexcept;
    // executor_path.cpp: path segments
    Progress begin_path(std::uint64_t tick) noexcept;
    Progress advance_path(std::uint64_t tick) noexcept;
    void enter_segment(std::uint64_t tick) noexcept;
    void turn_for_segment(std::uint64_t tick) noexcept;
    void turn_idle_axes(std::uint64_t tick) noexcept;
    // executor_halts.cpp: rests at the ends of a program's lines, or at its optional stops
    bool is_wanted(const LineStop& stop) const noexcept { return (stop.mark() & wanted_marks_) != 0; }
    bool is_stop_at_hand() const noexcept;
    std::optional<LineStop::Bounds> stop_bounds() const noexcept;
    void forget_stops() noexcept;
    bool is_halt_wanted() noexcept;
    bool rested_at_mark() noexcept;
    void look_for_line_end() noexcept;
    void look_at_rest() noexcept;
    void bound_segment() noexcept;
    bool rests_at_line_end() const noexcept;
    void rest_at_line_end() noexcept;

    const MotionBlock& block() const noexcept { return feed_.block(); }

    PulseStage* pulses_;
    double period_s_;  ///< of the interpolation

    BlockFeed feed_;
    SensorSearch search_;
    RunProgress progress_;
    Iterations iterations_;  ///< lines, path segments
    LinearProfile profile_;  ///< lines
    PathPace pace_;          ///< path segments
    FineMove fine_;          ///< moves
    /// Path segments: of the ends of lines and of optional stops, each by itself.
    std::array<LineStop, 2> line_stops_{LineStop{kEndsLine}, LineStop{kOptionalStop}};
    TakeUp take_up_;  ///< is on: the block at hand has not begun, its axes cross their gaps first

    double feed_ratio_ = 1.0;
    double rapid_ratio_ = 1.0;
    bool is_near_feed_ = false;  ///< a rapid way has come to where the feed's override holds, too
    std::uint32_t still_axes_ = 0;
    bool in_motion_ = false;
    bool slowing_ = false;
    std::uint8_t wanted_marks_ = 0;
    std::uint8_t rested_marks_ = 0;
    bool has_line_ended_ = false;  ///< it rests on the path for that, and kLineDone is not told yet
    bool starts_again_ = false;    ///< the next segment begins behind such a rest
    std::int64_t latch_correction_ = 0;
};

}  // namespace psicarve::cycle
