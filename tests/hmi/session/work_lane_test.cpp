// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/work_lane.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

namespace psicarve::session {
namespace {

void finish_all(WorkLane& lane) {
    while (!lane.is_idle()) {
        lane.deliver();
        std::this_thread::yield();
    }
}

TEST(WorkLane, WorksInOrderElsewhereAndDeliversHere) {
    WorkLane sut;
    std::vector<int> delivered;
    const auto here = std::this_thread::get_id();
    for (int i = 0; i < 100; ++i) {
        sut.post([&delivered, i, here]() -> WorkLane::Finish {
            const bool is_elsewhere = std::this_thread::get_id() != here;
            return [&delivered, i, is_elsewhere] { delivered.push_back(is_elsewhere ? i : -1); };
        });
    }
    finish_all(sut);
    ASSERT_EQ(delivered.size(), 100U);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(delivered[static_cast<std::size_t>(i)], i);
}

TEST(WorkLane, DropsWhatWaitsAndEndsWhatRuns) {
    std::atomic<int> done{0};
    std::promise<void> begun;
    std::promise<void> may_end;
    {
        WorkLane sut;
        sut.post([&]() -> WorkLane::Finish {
            begun.set_value();
            may_end.get_future().wait();
            ++done;
            return {};
        });
        sut.post([&]() -> WorkLane::Finish {
            done += 100;
            return {};
        });
        begun.get_future().wait();
        sut.drop_waiting();
        may_end.set_value();
    }
    EXPECT_EQ(done.load(), 1);
}

TEST(WorkLane, IsWaitedForUntilAllIsDone) {
    std::atomic<int> done{0};
    WorkLane sut;
    sut.finish();
    for (int i = 0; i < 20; ++i) {
        sut.post([&]() -> WorkLane::Finish {
            std::this_thread::sleep_for(std::chrono::milliseconds{2});
            ++done;
            return {};
        });
    }
    sut.finish();
    EXPECT_EQ(done.load(), 20);
}

TEST(WorkLane, GivesWayToOthersWithLongWork) {
    const auto priority_on = [](WorkLane::Haste haste) {
        WorkLane sut{haste};
        int priority = -100;
        sut.post([&priority]() -> WorkLane::Finish {
            const int mine = ::getpriority(PRIO_PROCESS, 0);  // of the thread
            return [&priority, mine] { priority = mine; };
        });
        finish_all(sut);
        return priority;
    };
    const int here = ::getpriority(PRIO_PROCESS, 0);
    EXPECT_EQ(priority_on(WorkLane::Haste::prompt), here);
    EXPECT_GE(priority_on(WorkLane::Haste::background), 10);
    EXPECT_EQ(::getpriority(PRIO_PROCESS, 0), here);
}

TEST(WorkLane, TakesNewTasksFromItsDeliveries) {
    WorkLane sut;
    int count = 0;
    std::function<WorkLane::Finish()> task = [&]() -> WorkLane::Finish {
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
