// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/replay/recorded_run.hpp"

#include <algorithm>

namespace psicarve::replay::test {

PlainTrace::PlainTrace(const std::string& path) {
    const auto reader = verify::open_trace(path);
    EXPECT_TRUE(reader);
    const verify::TraceStart& start = (*reader)->start();
    states.push_back({0, start.initial_levels, start.position_pulses, {}});
    std::vector<verify::TraceEvent> events(100);
    while (true) {
        const auto count = (*reader)->read(events);
        EXPECT_TRUE(count);
        if (!count || *count == 0) return;
        for (std::size_t i = 0; i < *count; ++i) {
            const verify::TraceEvent& event = events[i];
            At next = states.back();
            next.time_ns = event.time_ns;
            if (event.kind == verify::TraceEvent::Kind::position)
                next.position_pulses = event.position_pulses;
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                const bool rose = (~next.levels & event.levels & (1U << k)) != 0;
                if (!rose) continue;
                ++next.pulses[k];
                if ((event.levels & (0x100U << k)) == 0) continue;
                next.position_pulses[k] += (event.levels & (0x10U << k)) != 0 ? 1 : -1;
            }
            next.levels = event.levels;
            states.push_back(next);
        }
    }
}

const PlainTrace::At& PlainTrace::at(std::int64_t time_ns) const {
    const auto later = std::upper_bound(states.begin() + 1, states.end(), time_ns,
                                        [](std::int64_t t, const At& state) { return t < state.time_ns; });
    return *(later - 1);
}

}  // namespace psicarve::replay::test
