// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/verify/verify_report.hpp"
#include "shared/job/job.hpp"

namespace psicarve::verify {

/// When an attempt at carving left its first point, reached its others, and was last on its way.
class CarveTimes {
public:
    /// The first one since `begin_anew` counts.
    void leave(std::int64_t time_ns) noexcept {
        if (!has_left_) left_ns_ = time_ns;
        has_left_ = true;
    }
    void arrive(std::int64_t time_ns) noexcept { arrived_ns_ = time_ns; }
    /// On the way to a point; on the way out from the path it is not.
    void go(std::int64_t time_ns) noexcept { gone_ns_ = time_ns; }
    /// With the point that was reached last.
    void end_pass() { pass_ended_ns_.push_back(arrived_ns_); }
    void begin_anew() noexcept {
        has_left_ = false;
        gone_ns_ = 0;
        pass_ended_ns_.clear();
    }

    std::int64_t arrived_ns() const noexcept { return arrived_ns_; }
    /// From leaving the first point to reaching the last [s]; 0: it was never left, or nothing
    /// was reached since.
    double carve_seconds() const noexcept;
    /// From leaving the first point to the last pulse on the path [s]; 0: there was none.
    double seconds_so_far() const noexcept;
    /// Nothing for a job of one pass, or where passes are missing.
    std::vector<PassTime> pass_times(const JobView& job) const;

private:
    bool has_left_ = false;
    std::int64_t left_ns_ = 0;
    std::int64_t arrived_ns_ = 0;
    std::int64_t gone_ns_ = 0;
    std::vector<std::int64_t> pass_ended_ns_;
};

}  // namespace psicarve::verify
