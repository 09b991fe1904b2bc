// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/background_queue.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

namespace psicarve::session {
namespace {

void finish_all(BackgroundQueue& queue) {
    while (!queue.is_idle()) {
        queue.deliver();
        std::this_thread::yield();
    }
}

TEST(BackgroundQueue, WorksInOrderElsewhereAndDeliversHere) {
    BackgroundQueue sut;
    std::vector<int> delivered;
    const auto here = std::this_thread::get_id();
    for (int i = 0; i < 100; ++i) {
        sut.post([&delivered, i, here]() -> BackgroundQueue::Finish {
            const bool is_elsewhere = std::this_thread::get_id() != here;
            return [&delivered, i, is_elsewhere] { delivered.push_back(is_elsewhere ? i : -1); };
        });
    }
    finish_all(sut);
    ASSERT_EQ(delivered.size(), 100U);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(delivered[static_cast<std::size_t>(i)], i);
}

TEST(BackgroundQueue, DropsWhatWaitsAndEndsWhatRuns) {
    std::atomic<int> done{0};
    std::promise<void> begun;
    std::promise<void> may_end;
    {
        BackgroundQueue sut;
        sut.post([&]() -> BackgroundQueue::Finish {
            begun.set_value();
            may_end.get_future().wait();
            ++done;
            return {};
        });
        sut.post([&]() -> BackgroundQueue::Finish {
            done += 100;
            return {};
        });
        begun.get_future().wait();
        sut.drop_waiting();
        may_end.set_value();
    }
    EXPECT_EQ(done.load(), 1);
}

TEST(BackgroundQueue, IsWaitedForUntilAllIsDone) {
    std::atomic<int> done{0};
    BackgroundQueue sut;
    sut.finish();
    for (int i = 0; i < 20; ++i) {
        sut.post([&]() -> BackgroundQueue::Finish {
            std::this_thread::sleep_for(std::chrono::milliseconds{2});
            ++done;
            return {};
        });
    }
    sut.finish();
    EXPECT_EQ(done.load(), 20);
}

TEST(BackgroundQueue, GivesWayToOthersWithLongWork) {
    const auto priority_on = [](BackgroundQueue::Haste haste) {
        BackgroundQueue sut{haste};
        int priority = -100;
        sut.post([&priority]() -> BackgroundQueue::Finish {
            const int mine = ::getpriority(PRIO_PROCESS, 0);  // of the thread
            return [&priority, mine] { priority = mine; };
        });
        finish_all(sut);
        return priority;
    };
    const int here = ::getpriority(PRIO_PROCESS, 0);
    EXPECT_EQ(priority_on(BackgroundQueue::Haste::prompt), here);
    EXPECT_GE(priority_on(BackgroundQueue::Haste::background), 10);
    EXPECT_EQ(::getpriority(PRIO_PROCESS, 0), here);
}

TEST(BackgroundQueue, TakesNewTasksFromItsDeliveries) {
    BackgroundQueue sut;
    int count = 0;
    std::function<BackgroundQueue::Finish()> task = [&]() -> BackgroundQueue::Finish {
        return [&] {
            if (++count < 5) sut.post(task);
        };
    };
    sut.post(task);
    finish_all(sut);
    EXPECT_EQ(count, 5);
}

}  // namespace
}  // namespace psicarve::session
