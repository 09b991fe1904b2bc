// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/path.hpp"
#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/path_stretch.hpp"
#include "rtcore/plan/program.hpp"
#include "rtcore/plan/program_step.hpp"

namespace psicarve::plan {

/// A program of motion records by look-ahead. Ways are gathered until something brings the machine to rest:
///
///     exact end | tolerance changes | dwell, spindle, stop, end | kWindowPoints since the last rest
///
/// and only then planned, as far as they go: so curves, cuts and pulses follow from the program alone, never
/// from when its records came. Holds one such window in memory.
class RecordProgram final : public Program {
public:
    /// So many path points from one rest to the next at most: what they take of the queue's room and of time
    /// to plan is little, and a stop after so many of a dense program's points costs next to nothing.
    static constexpr std::size_t kWindowPoints = 2048;

    /// `is_single`: a halt after each block of the program.
    RecordProgram(const MachineLimits& limits, std::shared_ptr<StepSource> source,
                  const Pulses4& start_pulses, bool is_single = false);

    bool next(cycle::MotionBlock& block) override;
    bool is_waiting() const override { return is_waiting_; }

private:
    /// Of the program; its path points may be several.
    struct Way {
        std::uint64_t line;
        double seconds;  ///< least
        bool is_rapid;
        std::size_t last_point;
    };

    bool make_blocks();
    void take(const ProgramStep& step);
    void take_way(const ProgramStep& step);
    void add_way(const ProgramStep& step);
    void come_to_rest();
    void plan_stretch(std::size_t first, std::size_t last);
    void set_limits();
    void pace_spans();
    void halt(ProgramHold hold, std::uint64_t line);
    void switch_spindle(bool is_on, std::uint64_t line);
    void dwell(std::int64_t ticks, std::uint64_t line);
    void end(std::uint64_t line);
    cycle::MotionBlock& add_block(cycle::BlockKind kind, std::uint64_t line);

    MachineLimits machine_;  ///< as the tick has it
    MachineLimits limits_;   ///< for the window at hand
    std::shared_ptr<StepSource> source_;
    bool is_single_;
    bool is_waiting_ = false;
    bool is_ended_ = false;
    std::uint64_t line_ = 0;  ///< of the step taken last

    // The window at hand: from where the machine rests.
    std::vector<PathPoint> points_;
    std::vector<Way> ways_;
    double tolerance_mm_ = 0.0;  ///< 0: none of its ways has one

    std::optional<StretchPlanner> stretches_;  ///< for limits_
    double planned_tolerance_mm_ = -1.0;
    std::vector<PathSpan> spans_;
    std::vector<PathCorner> corners_;
    std::vector<PathPiece> pieces_;
    std::vector<cycle::MotionBlock> blocks_;
    std::size_t next_ = 0;
};

}  // namespace psicarve::plan
