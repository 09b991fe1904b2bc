// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/event.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace psicarve {
namespace {

using std::chrono::milliseconds;

TEST(Event, WaitEndsAtItsLimitWithoutASignal) {
    EventWord event{};

    EXPECT_FALSE(event_wait_past(event, event_count(event), milliseconds{5}));
}

TEST(Event, SignalBeforeTheWaitIsNotLost) {
    EventWord event{};
    const std::uint32_t seen = event_count(event);

    event_signal(event);

    EXPECT_TRUE(event_wait_past(event, seen, milliseconds{0}));
}

TEST(Event, NegativeLimitDoesNotWait) {
    EventWord event{};

    EXPECT_FALSE(event_wait_past(event, event_count(event), milliseconds{-100}));
}

TEST(Event, CounterThatWrapsAroundStillWakes) {
    EventWord event{};
    event.counter.store(0xFFFFFFFF);
    const std::uint32_t seen = event_count(event);

    event_signal(event);

    EXPECT_EQ(event_count(event), 0U);
    EXPECT_TRUE(event_wait_past(event, seen, milliseconds{0}));
}

TEST(Event, EverySignalIsSeenByAWaitingThread) {
    constexpr int kRounds = 2000;
    EventWord ping{};
    EventWord pong{};
    std::thread other{[&] {
        std::uint32_t seen = 0;
        for (int round = 0; round < kRounds; ++round) {
            while (!event_wait_past(ping, seen, milliseconds{60'000})) {
            }
            ++seen;
            event_signal(pong);
        }
    }};

    std::uint32_t seen = 0;
    for (int round = 0; round < kRounds; ++round) {
        event_signal(ping);
        ASSERT_TRUE(event_wait_past(pong, seen, milliseconds{60'000}));
        ++seen;
    }
    other.join();

    EXPECT_EQ(event_count(pong), static_cast<std::uint32_t>(kRounds));
}

}  // namespace
}  // namespace psicarve
