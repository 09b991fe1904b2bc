// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/cycle/layer_range.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::cycle {

/// The job at hand and the run of its layers: which of them, when each part of the run began and ended, and
/// in which layer psi was last known to be right. Its figures outlive the run, for the status, until the
/// next. Fifteen plain figures, all of which the status or the planner shows. RT: yes.
class JobRun {
public:
    /// The layers that an alarm affects. count 0: none.
    struct Affected {
        std::uint32_t first_layer;
        std::uint16_t layer_count;
    };

    /// Requires that no run is under way. Feed and rapid ways are as planned again. `runs_back`: odd layers
    /// are carved from their table's last point to its first.
    void load(std::uint64_t generation, std::uint64_t points_total, std::uint64_t points_per_layer,
              bool runs_back = false) noexcept;
    /// none: these layers can be run.
    Refusal judge(LayerRange layers) const noexcept;
    /// Requires judge() to say none.
    void begin(LayerRange layers, std::uint64_t tick) noexcept;

    /// Whether the first point is left and the carving goes on, or is done.
    bool has_begun_carving() const noexcept { return carve_first_tick_ != 0; }
    /// Acceleration groups of the carving begin; the first of them counts.
    void note_group(std::uint64_t tick) noexcept {
        if (!has_begun_carving()) carve_first_tick_ = tick;
    }
    /// So many points of the job are reached. The first tick counts in which they are all of the run.
    void note_points(std::uint64_t points_reached, std::uint64_t tick) noexcept {
        // A spiral's row ends in the point that is the next one's first, too.
        if (carve_last_tick_ == 0 && points_reached >= end_layer_ * points_per_layer_)
            carve_last_tick_ = tick;
    }
    /// psi stood where its index says, while this layer was at hand.
    void note_index(std::uint32_t layer) noexcept {
        if (has_begun_carving()) index_layer_ = layer;
    }
    void end(std::uint64_t tick) noexcept { end_tick_ = tick; }

    /// The layers that may be wrong when psi is found to be, in `layer`: from the last whose index was right.
    Affected affected(std::uint32_t layer) const noexcept;

    /// Points of the job before the run's first.
    std::uint64_t points_before() const noexcept { return first_layer_ * points_per_layer_ + first_step_; }
    std::uint64_t generation() const noexcept { return generation_; }
    bool is_dry() const noexcept { return is_dry_; }

    /// Of the planned feed while carving; stays through alarms until the next job is loaded.
    void set_override(std::uint64_t percent) noexcept { override_percent_ = percent; }
    /// One that slows down stays.
    void end_raised_override() noexcept {
        override_percent_ = std::min<std::uint64_t>(override_percent_, kFullFeed_percent);
    }
    double feed_ratio() const noexcept { return static_cast<double>(override_percent_) / 100.0; }
    /// Of the speed of a program's rapid ways; stays as long as that of the feed does.
    void set_rapid_override(std::uint64_t percent) noexcept { rapid_override_percent_ = percent; }
    double rapid_ratio() const noexcept { return static_cast<double>(rapid_override_percent_) / 100.0; }

    void show_in(Sample& sample) const noexcept;
    void show_in(PlanRequest& request) const noexcept;

private:
    std::uint64_t first_step_of(const LayerRange& layers) const noexcept;

    std::uint64_t generation_ = 0;
    std::uint64_t points_total_ = 0;
    std::uint64_t points_per_layer_ = 0;
    std::uint64_t override_percent_ = kFullFeed_percent;
    std::uint64_t rapid_override_percent_ = kFullFeed_percent;
    bool runs_back_ = false;
    std::uint64_t first_layer_ = 0;
    std::uint64_t first_step_ = 0;  ///< of that layer's points, in the order in which they are carved
    std::uint64_t end_layer_ = 0;   ///< one past the last that is to be carved
    std::uint32_t index_layer_ =
        0;  ///< in which psi last was where its index says; the first, if in none yet
    bool is_dry_ = false;
    std::uint64_t start_tick_ = 0;
    std::uint64_t carve_first_tick_ = 0;
    std::uint64_t carve_last_tick_ = 0;
    std::uint64_t end_tick_ = 0;
};

}  // namespace psicarve::cycle
