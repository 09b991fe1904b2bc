// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of another run are laid onto no trace, wherever among many they differ.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "hmi/replay/trace_recording.hpp"
#include "tests/hmi/replay/recorded_run.hpp"

namespace psicarve::replay {
namespace {

class RecordsFit : public test::RecordedRun {
protected:
    bool fit(const Snapshot& snapshot) {
        EXPECT_TRUE(save_snapshot(snapshot, file("many.snap")));
        const auto opened = open_recording({trace(), file("many.snap"), Profile{}}, {});
        EXPECT_TRUE(opened);
        return opened && (*opened)->facts().knows_states;
    }
};

// Of many entries some are looked at, and the last in any case.
TEST_F(RecordsFit, OnlyWithTheLastOfThem) {
    record();
    auto many = load_snapshot(snapshot());
    ASSERT_TRUE(many);
    const auto middle = static_cast<std::ptrdiff_t>(many->records.size() / 2);
    const FlightRecord copied = many->records[static_cast<std::size_t>(middle)];
    many->records.insert(many->records.begin() + middle, 200 - many->records.size(), copied);
    for (const std::size_t count : {200U, 201U, 202U}) {
        while (many->records.size() < count) many->records.insert(many->records.begin() + middle, copied);
        EXPECT_TRUE(fit(*many)) << count;
        auto other = *many;
        other.records.back().position_pulses[1] += 5;
        EXPECT_FALSE(fit(other)) << count;
    }
}

}  // namespace
}  // namespace psicarve::replay
