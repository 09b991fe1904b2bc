// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/path.hpp"
#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/path_stretch.hpp"
#include "rtcore/plan/program.hpp"
#include "rtcore/plan/program_step.hpp"
#include "rtcore/plan/receding_speeds.hpp"
#include "rtcore/plan/stepped_program.hpp"

namespace psicarve::plan {

/// A program of motion records by look-ahead. Ways are gathered until something brings the machine to rest:
///
///     exact end | tolerance changes | dwell, spindle, output, stop, end
///
/// or until there are so many points that a part of the way can be decided for good, whatever comes behind:
///
///     rest                                                                     | gathered so far
///       |-- kPartPoints --|-- kPartPoints --|-- kPartPoints --|-- kTailPoints --|
///         settled: a group   settled now       curve decided     will be fitted again
///         that goes on       (RecedingSpeeds)
///
/// So curves, cuts and pulses follow from the program alone, never from when its records came. Holds no more
/// than that in memory. Its members: the limits, the window of points and what is settled in it, the planners
/// of a part, and memory for what they make: all of it moves on with the window.
class RecordProgram final : public Program {
public:
    /// A part is longer than what the axes take to come to rest; blocks for two of them fill the queue by
    /// half at most.
    static constexpr std::size_t kPartPoints = 512;
    /// How the path goes on so many points later does not bend it.
    static constexpr std::size_t kTailPoints = 32;

    /// `is_single`: a halt after each block of the program. `part_points`: other than kPartPoints for a
    /// yardstick alone; with more than a program has, the ways between two rests are planned at once.
    RecordProgram(const MachineLimits& limits, std::shared_ptr<StepSource> source,
                  const Pulses4& start_pulses, bool is_single = false, std::size_t part_points = kPartPoints);

    /// As StretchPlanner does.
    void show(std::vector<SeenCell>* seen) noexcept { seen_ = seen; }

    bool next(cycle::MotionBlock& block) override;
    bool is_waiting() const override { return is_waiting_; }

private:
    /// What a way of the program asks for, at each of its path points.
    struct Way {
        RecordPlace place;
        Timings least_pace2;
        double longer_by_s;  ///< the ways since the point before, by rounding; on the last point of each
    };

    bool make_blocks();
    void take(const ProgramStep& step);
    ProgramStep at_the_programs_pace(const ProgramStep& step);
    bool is_very_long(const ProgramStep& step) const;
    void end_line(std::uint64_t line);
    void may_stop(const ProgramStep& step);
    void take_way(const ProgramStep& step);
    void take_very_long_way(const ProgramStep& step);
    void take_stepped(const ProgramStep& step);
    bool next_stepped(cycle::MotionBlock& block);
    void add_way(const ProgramStep& step);
    /// Of those that ways bear: with is_single_ each line ends in a halt of its own.
    std::uint8_t marks_on_ways() const noexcept {
        return is_single_ ? cycle::kOptionalStop : cycle::kOptionalStop | cycle::kEndsLine;
    }
    void come_to_rest();
    void go_ahead();
    std::size_t plan_up_to_rests();
    std::size_t next_rest() const;
    void close_run(std::size_t point);
    void rest_where_decided();
    void rest_at(std::size_t point);
    void drop_points(std::size_t count);
    void look_at_spans();
    void set_paces();
    double staircase_share(const std::vector<double>& pace, std::size_t span) const;
    void set_limits();
    bool decide_part(std::size_t to);
    void plan_stretch(std::size_t first, std::size_t last);
    void settle(CurvePart part);
    void end_run();
    Timings least_pace2(const ProgramStep& step, std::size_t first) const;
    std::vector<RecordPlace> lines_of(std::size_t first, std::size_t last) const;
    void add_group(std::span<const RecordPlace> lines, unsigned joints, bool feed_follows = false);
    /// `marks`: it waits only where one of them is wanted; 0: always.
    void halt(ProgramHold hold, std::uint64_t line, std::uint8_t marks = 0);
    void halt_single(std::uint64_t line) { halt(ProgramHold::single, line, cycle::kEndsLine); }
    cycle::MotionBlock& add_switch(std::uint64_t line);
    void switch_spindle(bool is_on, std::uint64_t line);
    void switch_outputs(SwitchedOutputs outputs, bool is_on, std::uint64_t line);
    void dwell(std::int64_t ticks, std::uint64_t line);
    void end(std::uint64_t line);
    cycle::MotionBlock& add_block(cycle::BlockKind kind, std::uint64_t line);

    MachineLimits machine_;  ///< as the tick has it
    MachineLimits limits_;   ///< for the window at hand
    std::shared_ptr<StepSource> source_;
    bool is_single_;
    std::size_t part_points_;
    bool is_waiting_ = false;
    bool is_ended_ = false;
    std::uint64_t line_ = 0;      ///< of the step taken last
    std::uint64_t sequence_ = 0;  ///< of that step
    Pulses4 asked_pulses_;        ///< where the last way of the program ends
    Lanes rounded_off_pulses_{};  ///< and what its end lost by that
    double longer_by_s_ = 0.0;    ///< of ways behind the last point

    // A way by point-by-point comparison: its blocks come one by one, behind blocks_.
    std::optional<SteppedProgram> stepped_;
    bool halts_behind_stepped_ = false;
    bool ends_behind_stepped_ = false;  ///< its line does

    // The window at hand, from where the machine rests or the curve is decided up to.
    std::vector<PathPoint> points_;
    std::vector<Way> ways_;  ///< by point: that which reaches it
    std::size_t begin_ = 0;  ///< index of that point; points before it only show where the path comes from
    bool is_open_ = false;   ///< no rest there: the part before is held in speeds_
    double tolerance_mm_ = 0.0;  ///< 0: none of its ways has one
    GapWays gap_ways_{};         ///< of what came before the window

    std::optional<StretchPlanner> stretches_;  ///< for limits_
    RecedingSpeeds speeds_;
    bool carries_on_ = false;  ///< the part held there goes on behind a group that was made
    double planned_tolerance_mm_ = -1.0;
    std::vector<PathSpan> spans_;
    std::vector<PathCorner> corners_;
    std::vector<PathPiece> pieces_;
    std::vector<SeenCell>* seen_ = nullptr;
    std::vector<cycle::MotionBlock> blocks_;
    std::size_t next_ = 0;
};

}  // namespace psicarve::plan
