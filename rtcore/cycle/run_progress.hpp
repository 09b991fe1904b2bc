// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::cycle {

/// How far a run has come in its job, in points, and for how long the pins kept it waiting. RT: yes.
class RunProgress {
public:
    /// A run begins, after so many points of the job.
    void begin(std::uint64_t points_before) noexcept {
        layer_ = 0;
        point_ = 0;
        points_reached_ = points_before;
        waited_ticks_ = 0;
    }
    /// So many points are reached at once; the last of them is this.
    void reach(std::uint32_t layer, std::uint32_t point, std::uint32_t points) noexcept {
        layer_ = layer;
        point_ = point;
        points_reached_ += points;
    }
    /// In this tick an iteration was due, and the pins were not ready for it.
    void note_wait() noexcept { ++waited_ticks_; }

    /// The point that was reached last: its layer, and its number in it. 0 and 0 before the first.
    std::uint32_t layer() const noexcept { return layer_; }
    std::uint32_t point() const noexcept { return point_; }
    /// Of the job, those before the run included.
    std::uint64_t points_reached() const noexcept { return points_reached_; }
    std::uint64_t waited_ticks() const noexcept { return waited_ticks_; }

private:
    std::uint32_t layer_ = 0;
    std::uint32_t point_ = 0;
    std::uint64_t points_reached_ = 0;
    std::uint64_t waited_ticks_ = 0;
};

}  // namespace psicarve::cycle
