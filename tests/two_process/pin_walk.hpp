// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::two_process {

/// One instant at which axes step together.
struct Step {
    std::int64_t time_ns;
    std::array<std::int8_t, kAxisCount> way_pulses;
    SignalWord levels;
};

/// A pin trace as the way it went.
struct PinWalk {
    std::vector<Step> steps;
    /// Where the axes stood before steps[i], as the core counted; one more than steps.
    std::vector<std::array<std::int64_t, kAxisCount>> positions_pulses;
};

/// Fails the test when the trace cannot be read.
PinWalk walk_of(const std::string& trace_path, const Profile& profile);

/// The first step after the point was reached; nothing is at it: steps.size().
std::size_t first_step_at(const PinWalk& walk, const JobView& job, std::uint32_t layer, std::uint32_t point,
                          std::size_t from = 0);

/// The ways alone, from a step on: what "the same pulses in the same order" compares.
std::vector<std::array<std::int8_t, kAxisCount>> order_from(const PinWalk& walk, std::size_t first,
                                                            std::size_t end);

}  // namespace psicarve::two_process
