// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/computer/realtime_step.hpp"

namespace psicarve::machine {

struct LatencyOptions {
    std::uint32_t period_us = 50;
    std::uint32_t seconds = 10;
    std::uint32_t priority = kTickPriority;
    std::string cpu;  ///< a number or "any"; empty: the core chooses
};

struct LatencyProgress {
    std::uint32_t seconds = 0;
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0;
    std::int64_t max_ns = 0;
};

/// How late the core's tick loop was with an empty tick.
struct LatencyResult {
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0;
    std::int64_t max_ns = 0;
    std::uint64_t page_faults = 0;
    std::uint64_t preemptions = 0;
    int cpu = -1;                                               ///< -1: any
    int priority = 0;                                           ///< 0: not scheduled in real time
    std::vector<std::string> refused;                           ///< steps of the real-time setup
    std::vector<std::pair<std::uint32_t, std::uint64_t>> bins;  ///< microseconds late, ticks; rising

    /// The lateness that this share (0 to 1) of the ticks does not exceed [us], as if they lay evenly in
    /// their microsecond.
    double late_us(double share) const noexcept;
};

/// One line of what psicarve-rtcore --measure-latency prints.
Result<LatencyResult> latency_result_from(std::string_view line);

/// Lets psicarve-rtcore measure. `progress` gets each second; once `must_end` returns true the measurement so
/// far is the result.
Result<LatencyResult> measure_latency(const LatencyOptions& options,
                                      const std::function<void(const LatencyProgress&)>& progress,
                                      const std::function<bool()>& must_end);

}  // namespace psicarve::machine
