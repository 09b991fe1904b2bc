// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/rt_setup.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "rtcore/realtime/thread_counts.hpp"
#include "tests/shared/temporary_folder.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::rtcore {
namespace {

// Sanitizers answer mlockall() themselves: done, whatever the limits.
constexpr bool kLocksMemory = !test::kIsSanitized;

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
        const bool is_refused = step.outcome == SetupStep::Outcome::refused;
        if (step.detail.empty() || is_refused == step.remedy.empty()) return false;
    }
    return !steps.empty();
}

bool is_done(const std::vector<SetupStep>& steps, RealtimeStep step) {
    return (steps_done(steps) & bit_of(step)) != 0;
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
        const auto lines = report_of(steps);
        return !is_done(steps, RealtimeStep::scheduling) && each_failure_has_a_remedy(steps) &&
               lines.size() == 2 && lines[1].find("limits.d") != std::string::npos;
    }));
}

TEST(RtSetup, TellsSomebodyWithoutRightsHowToGetThem) {
    EXPECT_TRUE(holds_in_child([] {
        const rlimit none{.rlim_cur = 0, .rlim_max = 0};
        setrlimit(RLIMIT_RTPRIO, &none);
        setrlimit(RLIMIT_MEMLOCK, &none);
        if (geteuid() == 0 && setuid(65534) != 0) return false;
        const auto memory = set_up_process_memory();
        const auto thread = set_up_realtime_thread(kTickPriority);
        return is_done(memory, RealtimeStep::lock_memory) != kLocksMemory &&
               !is_done(thread, RealtimeStep::scheduling) && each_failure_has_a_remedy(memory) &&
               each_failure_has_a_remedy(thread);
    }));
}

TEST(RtSetup, ThreadRunsAsItWasReported) {
    EXPECT_TRUE(holds_in_child([] {
        const bool is_reported = is_done(set_up_realtime_thread(7), RealtimeStep::scheduling);
        int policy = 0;
        sched_param parameters{};
        pthread_getschedparam(pthread_self(), &policy, &parameters);
        return is_reported == (policy == SCHED_FIFO && parameters.sched_priority == 7);
    }));
}

std::set<int> allowed_cpus() {
    cpu_set_t allowed;
    sched_getaffinity(0, sizeof allowed, &allowed);
    std::set<int> cpus;
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
        if (CPU_ISSET(cpu, &allowed)) cpus.insert(cpu);
    }
    return cpus;
}

TEST(RtSetup, KeepsTheTickToItsProcessorAndOthersOffIt) {
    EXPECT_TRUE(holds_in_child([] {
        const std::set<int> before = allowed_cpus();
        const int cpu = *before.rbegin();
        std::set<int> others = before;
        if (others.size() > 1) others.erase(cpu);
        std::set<int> of_tick;
        bool is_told = false;
        keep_off_cpu(cpu);
        std::thread{[&] {
            is_told = is_done(set_up_realtime_thread(kTickPriority, cpu), RealtimeStep::tick_cpu);
            of_tick = allowed_cpus();
        }}.join();
        return is_told && of_tick == std::set<int>{cpu} && allowed_cpus() == others;
    }));
}

TEST(RtSetup, RefusesAProcessorThatIsNotThereAndSaysSo) {
    EXPECT_TRUE(holds_in_child([] {
        const auto steps = set_up_realtime_thread(kTickPriority, 1023);
        return !is_done(steps, RealtimeStep::tick_cpu) && each_failure_has_a_remedy(steps) &&
               (steps_asked(steps) & bit_of(RealtimeStep::tick_cpu)) != 0;
    }));
}

TEST(RtSetup, AsksForNoProcessorWhenNoneIsNamed) {
    EXPECT_TRUE(holds_in_child([] {
        return (steps_asked(set_up_realtime_thread(kTickPriority)) & bit_of(RealtimeStep::tick_cpu)) == 0;
    }));
}

TEST(RtSetup, TakesTheLastOfTheProcessorsThatTheKernelKeepsFree) {
    const std::string root = testing::TempDir() + "psicarve-isolated-" + std::to_string(getpid());
    const std::string folder = root + "/sys/devices/system/cpu";
    std::filesystem::create_directories(folder);
    const auto with_list = [&](const char* list) {
        std::ofstream{folder + "/isolated"} << list;
        return isolated_cpu(root);
    };
    EXPECT_EQ(with_list("2-3\n"), 3);
    EXPECT_EQ(with_list("5,1\n"), 5);
    EXPECT_EQ(with_list("\n"), std::nullopt);
    EXPECT_EQ(with_list("garbage\n"), std::nullopt);
    EXPECT_EQ(isolated_cpu(root + "/nowhere"), std::nullopt);
    std::filesystem::remove_all(root);
}

TEST(RtSetup, HoldsProcessorsAwakeByAFourByteZero) {
    const std::string path = testing::TempDir() + "psicarve-latency-" + std::to_string(getpid());
    std::ofstream{path} << "";
    {
        WakeLatencyHold sut;
        EXPECT_EQ(sut.hold(path.c_str()).outcome, SetupStep::Outcome::done);
        std::ifstream file{path, std::ios::binary};
        EXPECT_EQ((std::string{std::istreambuf_iterator<char>{file}, {}}), std::string(4, '\0'));
    }
    WakeLatencyHold elsewhere;
    const SetupStep refused = elsewhere.hold("/nowhere/cpu_dma_latency");
    EXPECT_EQ(refused.outcome, SetupStep::Outcome::refused);
    EXPECT_EQ(refused.remedy, kNoLatencyDeviceRemedy) << "no rule can let it write what is not there";
    const SetupStep forbidden = elsewhere.hold(testing::TempDir().c_str());
    EXPECT_EQ(forbidden.outcome, SetupStep::Outcome::refused);
    EXPECT_EQ(forbidden.remedy, remedy_of(RealtimeStep::wake_latency));
    unlink(path.c_str());
}

TEST(RtSetup, KnowsARealTimeKernel) {
    const test::TemporaryFolder folder;
    const auto put = [&](const std::string& path, const char* text) {
        std::filesystem::create_directories(std::filesystem::path{folder.path(path)}.parent_path());
        std::ofstream{folder.path(path)} << text;
    };
    EXPECT_FALSE(has_realtime_kernel(folder.path(""))) << "none of the files is there";
    put("proc/version", "Linux version 6.1.0-28-amd64 #1 SMP PREEMPT_DYNAMIC Debian 6.1.119-1\n");
    EXPECT_FALSE(has_realtime_kernel(folder.path("")));
    put("sys/kernel/realtime", "0\n");
    EXPECT_FALSE(has_realtime_kernel(folder.path("")));
    put("sys/kernel/realtime", "1\n");
    EXPECT_TRUE(has_realtime_kernel(folder.path("")));
    put("sys/kernel/realtime", "0\n");
    put("proc/version", "Linux version 6.1.0-28-rt-amd64 #1 SMP PREEMPT_RT Debian 6.1.119-1\n");
    EXPECT_TRUE(has_realtime_kernel(folder.path("")));
}

TEST(RtSetup, TouchedMemoryIsAsItWasAndFaultsNoMore) {
    constexpr std::size_t kBytes = std::size_t{16} << 20;
    auto* const memory = static_cast<unsigned char*>(
        mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    ASSERT_NE(memory, MAP_FAILED);
    madvise(memory, kBytes, MADV_NOHUGEPAGE);
    memory[0] = 42;
    memory[kBytes - 1] = 43;
    touch_pages(memory, kBytes);
    const auto before = counts_of_thread(gettid());
    for (std::size_t at = 0; at < kBytes; at += 4096) memory[at] = static_cast<unsigned char>(memory[at] + 1);
    const auto after = counts_of_thread(gettid());
    ASSERT_TRUE(before && after);
    EXPECT_EQ(memory[0], 43);
    EXPECT_EQ(memory[kBytes - 1], 43);
    // Reading /proc itself may fault now and then; 4096 pages would show.
    EXPECT_LT(after->since(*before).minor_faults, 1000U);
    munmap(memory, kBytes);
}

TEST(ThreadCounts, SeeTheFaultsAndSleepsOfAnotherThread) {
    constexpr std::size_t kBytes = std::size_t{16} << 20;
    std::promise<pid_t> thread;
    std::promise<void> may_go;
    std::promise<void> is_done;
    std::promise<void> may_end;
    std::thread other{[&] {
        thread.set_value(gettid());
        may_go.get_future().wait();
        void* const memory =
            mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        madvise(memory, kBytes, MADV_NOHUGEPAGE);
        touch_pages(memory, kBytes);
        for (int i = 0; i < 20; ++i) std::this_thread::sleep_for(std::chrono::milliseconds{1});
        munmap(memory, kBytes);
        is_done.set_value();
        may_end.get_future().wait();
    }};
    const pid_t id = thread.get_future().get();
    const auto before = counts_of_thread(id);
    may_go.set_value();
    is_done.get_future().wait();
    const auto after = counts_of_thread(id);
    may_end.set_value();
    other.join();
    ASSERT_TRUE(before && after);
    EXPECT_GE(after->since(*before).minor_faults, kBytes / 4096);
    EXPECT_GE(after->since(*before).sleeps, 20U);
    // Joined is not gone yet: the kernel takes its folder away a moment later.
    const std::string folder = "/proc/self/task/" + std::to_string(id);
    while (std::filesystem::exists(folder)) std::this_thread::yield();
    EXPECT_EQ(counts_of_thread(id), std::nullopt);
}

// What opens may still fail when it is read, as the files of a thread that ends between the two: like a
// folder.
TEST(ThreadCounts, AFileThatOpensAndCannotBeReadIsNoThread) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("proc/self/task/7/stat"));
    EXPECT_EQ(counts_of_thread(7, folder.path("")), std::nullopt);
    std::filesystem::remove(folder.path("proc/self/task/7/stat"));
    std::ofstream{folder.path("proc/self/task/7/stat")} << "7 (a) b) S 1 2 3 4 5 6 11 0 12 0 0\n";
    std::filesystem::create_directories(folder.path("proc/self/task/7/status"));
    EXPECT_EQ(counts_of_thread(7, folder.path("")), std::nullopt);
    std::filesystem::remove(folder.path("proc/self/task/7/status"));
    std::ofstream{folder.path("proc/self/task/7/status")}
        << "Name:\ta\nvoluntary_ctxt_switches:\t13\nnonvoluntary_ctxt_switches:\t14\n";
    const auto counts = counts_of_thread(7, folder.path(""));
    ASSERT_TRUE(counts);
    EXPECT_EQ(*counts,
              (ThreadCounts{.minor_faults = 11, .major_faults = 12, .sleeps = 13, .preemptions = 14}));
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
