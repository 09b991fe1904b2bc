// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/two_process/pin_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hmi/replay/pin_follower.hpp"
#include "hmi/trace/trace_reader.hpp"

namespace psicarve::two_process {
namespace {

void take(PinWalk& walk, replay::PinFollower& follower, const verify::TraceEvent& event) {
    const auto before = follower.moment().position_pulses;
    follower.take(event);
    const auto& after = follower.moment().position_pulses;
    if (event.kind == verify::TraceEvent::Kind::position) {
        walk.positions_pulses.back() = after;
        return;
    }
    if (after == before) return;
    Step step{event.time_ns, {}, event.levels};
    for (std::size_t k = 0; k < kAxisCount; ++k)
        step.way_pulses[k] = static_cast<std::int8_t>(after[k] - before[k]);
    walk.steps.push_back(step);
    walk.positions_pulses.push_back(after);
}

}  // namespace

PinWalk walk_of(const std::string& trace_path, const Profile& profile) {
    PinWalk walk;
    auto trace = verify::open_trace(trace_path);
    EXPECT_TRUE(trace.has_value()) << trace_path;
    if (!trace) return walk;
    replay::PinFollower follower{(*trace)->start(), profile};
    walk.positions_pulses.push_back(follower.moment().position_pulses);
    std::array<verify::TraceEvent, 1024> events;
    for (;;) {
        const auto count = (*trace)->read(events);
        EXPECT_TRUE(count.has_value()) << trace_path;
        if (!count || *count == 0) return walk;
        for (std::size_t i = 0; i < *count; ++i) take(walk, follower, events[i]);
    }
}

std::size_t first_step_at(const PinWalk& walk, const JobView& job, std::uint32_t layer, std::uint32_t point,
                          std::size_t from) {
    const std::array<std::int64_t, kAxisCount> wanted{
        job.r_left_pulses(layer)[point], job.r_right_pulses(layer)[point], job.psi_pulses(layer, point),
        job.y_pulses(layer, point)};
    const auto begin = walk.positions_pulses.begin();
    const auto found =
        std::find(begin + static_cast<std::ptrdiff_t>(from), walk.positions_pulses.end(), wanted);
    return std::min(static_cast<std::size_t>(found - begin), walk.steps.size());
}

std::vector<std::array<std::int8_t, kAxisCount>> order_from(const PinWalk& walk, std::size_t first,
                                                            std::size_t end) {
    std::vector<std::array<std::int8_t, kAxisCount>> order;
    for (std::size_t i = first; i < end && i < walk.steps.size(); ++i)
        order.push_back(walk.steps[i].way_pulses);
    return order;
}

}  // namespace psicarve::two_process
