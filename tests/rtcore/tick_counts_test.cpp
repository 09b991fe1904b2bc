// SPDX-License-Identifier: GPL-3.0-or-later
// No allocation, lock, page fault or system call in a million ticks: counted. tick_counters.cpp puts counters
// before the C library's own functions, so this is not built with a sanitizer, which does the same.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/futex.h>
#include <linux/ppdev.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "rtcore/port/parallel_port.hpp"
#include "rtcore/realtime/clock.hpp"
#include "rtcore/realtime/periodic.hpp"
#include "rtcore/realtime/rt_setup.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/tick_counters.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::cycle {
namespace {

using tick_counters::count_into;
using tick_counters::Counts;
using tick_counters::kPortDescriptor;

void expect_no_calls(const Counts& counts) {
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
    EXPECT_EQ(counts.other_system_calls, 0U) << "the last was number " << counts.last_other_call;
}

void expect_nothing(const Counts& counts) {
    expect_no_calls(counts);
    EXPECT_EQ(counts.page_faults, 0U);
}

/// Memory as the core treats it.
class TickCounts : public ::testing::Test {
protected:
    void start(Planner planner) {
        rtcore::set_up_process_memory();
        Profile profile = quick_profile();
        profile.job.planner = planner;
        rig_ = std::make_unique<MachineRig>(profile);
        rig_->port->records = false;
        ASSERT_TRUE(rig_->prepare(random_job(60, 200, 11)));
        rtcore::touch_heap();
        Request request{};
        request.kind = RequestKind::start_interpolation;
        rig_->io->requests.push(request);
    }
    /// In a thread of its own: one that is watched stays so.
    template <typename Work>
    void watched(Work&& work) {
        std::thread{[&] {
            ASSERT_TRUE(tick_counters::watch_this_thread());
            work();
        }}.join();
    }
    void drain() {
        Report report;
        while (rig_->io->reports.pop_into(report)) {
        }
        IncrementEntry entry;
        while (rig_->io->increments.pop_into(entry)) {
        }
    }
    void run_on_the_real_clock(std::uint64_t wanted_ticks, Counts& counts, rtcore::PeriodicStats& stats);

    std::unique_ptr<MachineRig> rig_;
};

void take_every_kind_of_lock() {
    const timespec past{};
    pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&mutex);
    pthread_mutex_unlock(&mutex);
    if (pthread_mutex_trylock(&mutex) == 0) pthread_mutex_unlock(&mutex);
    if (pthread_mutex_clocklock(&mutex, CLOCK_MONOTONIC, &past) == 0) pthread_mutex_unlock(&mutex);
    if (pthread_mutex_timedlock(&mutex, &past) == 0) pthread_mutex_unlock(&mutex);
    pthread_rwlock_t lock = PTHREAD_RWLOCK_INITIALIZER;
    for (const auto take :
         {pthread_rwlock_rdlock, pthread_rwlock_wrlock, pthread_rwlock_tryrdlock, pthread_rwlock_trywrlock}) {
        take(&lock);
        pthread_rwlock_unlock(&lock);
    }
    pthread_spinlock_t spin{};
    pthread_spin_init(&spin, PTHREAD_PROCESS_PRIVATE);
    pthread_spin_lock(&spin);
    pthread_spin_unlock(&spin);
    pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
    pthread_cond_timedwait(&condition, &mutex, &past);
    sem_t semaphore{};
    sem_init(&semaphore, 0, 1);
    sem_wait(&semaphore);
    sem_trywait(&semaphore);
}
constexpr std::uint64_t kKindsOfLock = 12;

TEST_F(TickCounts, TheCountersCountLocksAndMemory) {
    Counts counts;
    count_into(counts, take_every_kind_of_lock);
    EXPECT_EQ(counts.locks, kKindsOfLock);
    EXPECT_EQ(counts.allocations, 0U);
    count_into(counts, [] {
        const auto text = std::make_unique<std::string>(100, 'x');
        void* aligned = nullptr;
        if (posix_memalign(&aligned, 64, 64) == 0) std::free(aligned);
        auto* volatile page = static_cast<char*>(std::malloc(std::size_t{64} << 20));
        for (std::size_t at = 0; at < std::size_t{64} << 20; at += 4096) page[at] = text->front();
        std::free(page);
    });
    EXPECT_EQ(counts.allocations, 8U);
    EXPECT_GT(counts.page_faults, 0U);
}

TEST_F(TickCounts, TheCountersCountEverySystemCallWhoeverMakesIt) {
    Counts counts;
    watched([&] {
        count_into(counts, [] {
            const int file = open("/dev/zero", O_RDWR | O_CLOEXEC);
            char byte = 0;
            EXPECT_EQ(read(file, &byte, 1), 1);
            EXPECT_EQ(write(file, &byte, 1), 1);
            void* const page = mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            munmap(page, 4096);
            close(file);
            std::atomic<int> word{0};
            word.notify_all();
            syscall(SYS_futex, &word, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
            long number = SYS_getppid;
            asm volatile("syscall" : "+a"(number) : : "rcx", "r11", "memory");
            EXPECT_EQ(number, getppid());
        });
        EXPECT_EQ(counts.last_other_call, SYS_getppid);
        count_into(counts, [] {
            const timespec moment{.tv_sec = 0, .tv_nsec = 1'000'000};
            clock_nanosleep(CLOCK_MONOTONIC, 0, &moment, nullptr);
            std::uint8_t byte = 0;
            ioctl(kPortDescriptor, PPRSTATUS, &byte);
            EXPECT_EQ(byte, 0x80);
        });
    });
    EXPECT_EQ(counts.other_system_calls, 9U);
    EXPECT_EQ(counts.port_accesses, 1U);
    EXPECT_EQ(counts.sleeps, 1U);
    EXPECT_GE(counts.switches, 1U);
}

TEST_F(TickCounts, NothingInAMillionTicksOnTheVirtualClock) {
    for (const Planner planner : {Planner::lookahead, Planner::angle}) {
        ASSERT_NO_FATAL_FAILURE(start(planner));
        Counts counts;
        watched([&] {
            for (int tick = 0; tick < 500'000; ++tick) {
                if (rig_->planner->wants_poll()) rig_->planner->poll();
                count_into(counts, [&] { rig_->cycle->tick(); });
                if (tick % 64 == 0) drain();
            }
        });
        expect_nothing(counts);
        EXPECT_EQ(counts.sleeps, 0U);
        // They were worth it: it has carved.
        EXPECT_GT(rig_->cycle->sample().points_done, 1000U);
    }
}

TEST_F(TickCounts, OverARealPortOneReadAndTheRegistersThatChange) {
    ASSERT_NO_FATAL_FAILURE(start(Planner::lookahead));
    port::ParallelPort parallel{port::OpenPort{{}, port::PortAccess::ppdev(kPortDescriptor), "port"},
                                PinMap::from_profile(rig_->profile).value(),
                                port::PulseTimes{rig_->profile.port}, std::chrono::milliseconds{0}};
    rig_->port->beside = &parallel;
    constexpr std::uint64_t kTicks = 100'000;
    Counts counts;
    watched([&] {
        for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
            if (rig_->planner->wants_poll()) rig_->planner->poll();
            const std::uint64_t accesses = counts.port_accesses;
            count_into(counts, [&] { rig_->cycle->tick(); });
            EXPECT_GE(counts.port_accesses, accesses + 1U);
            EXPECT_LE(counts.port_accesses, accesses + 3U) << "status, data, control";
            if (tick % 64 == 0) drain();
        }
    });
    expect_nothing(counts);
    EXPECT_GT(counts.port_accesses, kTicks + 1000U) << "it has stepped";
    rig_->port->beside = nullptr;
}

/// These run on the real clock, so the suite takes fewer than the million that PSICARVE_LONG=1 does, in a
/// minute.
std::uint64_t ticks_on_the_real_clock() {
    return test::is_long_run() ? 1'000'000 : 50'000;
}

/// What the loop's own thread did in so many ticks.
void TickCounts::run_on_the_real_clock(std::uint64_t wanted_ticks, Counts& counts,
                                       rtcore::PeriodicStats& stats) {
    std::atomic<bool> is_over{false};
    std::thread base{[&] {
        ASSERT_TRUE(tick_counters::watch_this_thread());
        rtcore::set_up_realtime_thread(kTickPriority);
        rtcore::RealClock clock;
        std::uint64_t ticks = 0;
        count_into(counts, [&] {
            rtcore::run_periodic(clock, {.period_ns = 50'000}, stats,
                                 [&](const rtcore::PeriodicTick& tick) noexcept {
                                     if (tick.missed_before > 0)
                                         rig_->cycle->advance_missed(tick.missed_before);
                                     rig_->cycle->tick();
                                     return ++ticks < wanted_ticks;
                                 });
        });
        is_over.store(true);
    }};
    while (!is_over.load()) {
        if (rig_->planner->wants_poll()) rig_->planner->poll();
        drain();
        std::this_thread::sleep_for(std::chrono::microseconds{500});
    }
    base.join();
}

TEST_F(TickCounts, NothingInTheLoopOnTheRealClock) {
    const std::uint64_t wanted_ticks = ticks_on_the_real_clock();
    // The kernel may move a page that lies in memory, and a thread that touches it then faults by no doing of
    // its own: a few at a time. What the loop itself does it does every time: its faults would be there in
    // each of these runs. All else is its own doing in any run.
    constexpr int kMostRuns = 3;
    constexpr std::uint64_t kMostMoved_pages = 4;
    Counts counts;
    std::optional<rtcore::PeriodicStats> stats;
    for (int runs = 1; runs <= kMostRuns; ++runs) {
        ASSERT_NO_FATAL_FAILURE(start(Planner::lookahead));
        counts = {};
        stats.emplace();
        run_on_the_real_clock(wanted_ticks, counts, *stats);
        expect_no_calls(counts);
        EXPECT_EQ(stats->report().ticks_run, wanted_ticks);
        // One sleep a tick, and nothing else that it waits for.
        EXPECT_EQ(counts.sleeps, wanted_ticks);
        EXPECT_LE(counts.switches, wanted_ticks);
        ASSERT_LE(counts.page_faults, kMostMoved_pages);
        if (counts.page_faults == 0) break;
        std::printf("%llu page faults in run %d\n", static_cast<unsigned long long>(counts.page_faults),
                    runs);
    }
    EXPECT_EQ(counts.page_faults, 0U);
    std::printf("%llu ticks on the real clock, %llu more missed, %llu points carved: nothing counted\n",
                static_cast<unsigned long long>(wanted_ticks),
                static_cast<unsigned long long>(stats->report().ticks_missed),
                static_cast<unsigned long long>(rig_->cycle->sample().points_done));
}

}  // namespace
}  // namespace psicarve::cycle
