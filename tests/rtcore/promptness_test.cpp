// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/promptness.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <thread>

namespace psicarve::rtcore {
namespace {

struct Scheduling {
    int policy = 0;
    int priority = 0;
    friend bool operator==(const Scheduling&, const Scheduling&) = default;
};

Scheduling own_scheduling() {
    Scheduling own;
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &own.policy, &parameters);
    own.priority = parameters.sched_priority;
    return own;
}

bool set_own(const Scheduling& wanted) {
    const sched_param parameters{.sched_priority = wanted.priority};
    return pthread_setschedparam(pthread_self(), wanted.policy, &parameters) == 0;
}

constexpr Scheduling kOrdinary{SCHED_OTHER, 0};
constexpr Scheduling kPrompt{SCHED_FIFO, 1};

/// In a thread of its own: what it changes stays there.
template <typename Body>
void in_thread(Body&& body) {
    std::thread{body}.join();
}

/// What a thread may have of it here.
Scheduling prompt_here() {
    Scheduling here = kOrdinary;
    in_thread([&] { here = set_own(kPrompt) ? kPrompt : kOrdinary; });
    return here;
}

TEST(Promptness, GoesBeforeEverythingOrdinaryUntilItIsLowered) {
    const Scheduling prompt = prompt_here();
    in_thread([&] {
        Promptness sut{true};
        for (int round = 0; round < 2; ++round) {
            sut.raise();
            EXPECT_EQ(own_scheduling(), prompt);
            sut.lower();
            EXPECT_EQ(own_scheduling(), kOrdinary);
        }
    });
}

TEST(Promptness, EndsWithItself) {
    in_thread([] {
        {
            Promptness sut{true};
            sut.raise();
        }
        EXPECT_EQ(own_scheduling(), kOrdinary);
    });
}

TEST(Promptness, LeavesAThreadAloneThatIsARealtimeOneOrWantsNone) {
    in_thread([] {
        Promptness sut{false};
        sut.raise();
        EXPECT_EQ(own_scheduling(), kOrdinary);
    });
    in_thread([] {
        const Scheduling wanted{SCHED_FIFO, 7};
        const Scheduling before = set_own(wanted) ? wanted : Scheduling{SCHED_BATCH, 0};
        if (before.policy == SCHED_BATCH) set_own(before);
        Promptness sut{true};
        sut.raise();
        EXPECT_EQ(own_scheduling(), before);
        sut.lower();
        EXPECT_EQ(own_scheduling(), before);
    });
}

}  // namespace
}  // namespace psicarve::rtcore
