// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/program.hpp"
#include "rtcore/plan/tick_times.hpp"
#include "shared/job/job.hpp"

namespace psicarve::plan {

inline constexpr std::uint32_t kLastLayer = ~std::uint32_t{0};

/// Of a table: from the layer `first` up to, not including, `end`.
struct LayerSpan {
    std::uint32_t first = 0;
    std::uint32_t end = kLastLayer;
    std::uint32_t first_step = 0;  ///< point of `first` that is begun with, in the order of carving
};

/// The machine's limits for a job: its own feed, where it has one, and where heads are outside in it.
MachineLimits limits_of_job(const MachineLimits& limits, const JobView& job);
/// Where the machine stands in the point that is carved as a layer's `step`-th.
Pulses4 pulses_at(const JobView& job, std::uint32_t layer, std::uint32_t step);
/// Whether a layer is a row of a spiral, which only the finishing pass can be.
inline bool is_spiral_row(const JobView& job, std::uint32_t layer) {
    return job.joining() == Joining::spiral && layer >= job.finishing_layer();
}
/// So many layers from this one on are planned at once: nothing stops between the rows of a spiral, so each
/// begins as fast as the one before it ended.
std::uint32_t layers_at_once(const JobView& job, std::uint32_t layer);

/// A table or some of its layers, from a point of a layer (where the machine stands) to the last layer's
/// last point; how, is for the planners that derive from it to say. Makes few layers' blocks at a time.
class TableProgram : public Program {
public:
    bool next(cycle::MotionBlock& block) final;
    PlannedSoFar planned() const final { return planned_; }

protected:
    TableProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job, LayerSpan layers);

    /// Adds the blocks of the next layers, whole groups, to blocks_ and moves layer_ on, past them.
    virtual void make_layers() = 0;

    /// Whether the next layers to make are rows of a spiral, which only the finishing pass can be.
    bool is_spiral() const { return is_spiral_row(*job_, layer_); }
    bool begins_pass() const { return job_->begins_pass(layer_); }
    /// Heads clear between two passes.
    void add_way_to_pass(const Pulses4& from_pulses);
    std::uint32_t layers_at_once() const { return plan::layers_at_once(*job_, layer_); }
    Pulses4 point_at(std::uint32_t layer, std::uint32_t step) const { return pulses_at(*job_, layer, step); }
    /// The block ends in this point; a spiral's next row begins in it too.
    void reach(cycle::MotionBlock& block, std::uint32_t layer, std::uint32_t step);

    MachineLimits limits_;
    std::shared_ptr<const JobView> job_;
    std::uint32_t first_layer_;
    std::uint32_t first_step_;  ///< of that layer; its last is none
    std::uint32_t end_layer_;   ///< one past the last that is carved
    std::uint32_t layer_;       ///< the next one to make
    std::vector<cycle::MotionBlock> blocks_;
    PlannedSoFar planned_;

private:
    void make_blocks();

    TickTimes times_;
    std::size_t next_ = 0;
    bool is_ended_ = false;
};

}  // namespace psicarve::plan
