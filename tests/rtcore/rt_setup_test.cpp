// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/rt_setup.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace psicarve::rtcore {
namespace {

/// What set_up_* changes is the process's own: each test does it in a child. True when `body` said so.
template <typename Body>
bool holds_in_child(Body&& body) {
    const pid_t child = fork();
    if (child == 0) _exit(body() ? 0 : 1);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool each_failure_has_a_remedy(const std::vector<SetupStep>& steps) {
    for (const SetupStep& step : steps) {
        if (step.name.empty() || step.detail.empty() || step.ok != step.remedy.empty()) return false;
    }
    return !steps.empty();
}

TEST(RtSetup, SaysOfEveryStepWhatIsInForceOrWhatToDo) {
    EXPECT_TRUE(holds_in_child([] {
        return each_failure_has_a_remedy(set_up_process_memory()) &&
               each_failure_has_a_remedy(set_up_realtime_thread(kTickPriority));
    }));
}

TEST(RtSetup, ReportsARefusedSchedulerAndGoesOn) {
    EXPECT_TRUE(holds_in_child([] {
        const std::vector<SetupStep> steps = set_up_realtime_thread(1000);  // no such priority
        return !all_ok(steps) && each_failure_has_a_remedy(steps);
    }));
}

TEST(RtSetup, ThreadRunsAsItWasReported) {
    EXPECT_TRUE(holds_in_child([] {
        const bool ok = all_ok(set_up_realtime_thread(7));
        int policy = 0;
        sched_param parameters{};
        pthread_getschedparam(pthread_self(), &policy, &parameters);
        return ok == (policy == SCHED_FIFO && parameters.sched_priority == 7);
    }));
}

TEST(RtSetup, LeavesRoomForLargeSparseMappings) {
    EXPECT_TRUE(holds_in_child([] {
        const rlimit small{.rlim_cur = 64UL << 20, .rlim_max = 64UL << 20};
        setrlimit(RLIMIT_MEMLOCK, &small);
        set_up_process_memory();
        return mmap(nullptr, 512UL << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                    -1, 0) != MAP_FAILED;
    }));
}

}  // namespace
}  // namespace psicarve::rtcore
