// SPDX-License-Identifier: GPL-3.0-or-later
// No allocation, lock or page fault in a million ticks: counted. This program puts counters before the C
// library's own functions, so it is not built with a sanitizer, which does the same.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>

#include "rtcore/clock.hpp"
#include "rtcore/periodic.hpp"
#include "rtcore/rt_setup.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace {

thread_local bool is_counting = false;
thread_local std::uint64_t allocations = 0;
thread_local std::uint64_t locks = 0;

void note(std::uint64_t& counter) {
    if (is_counting) ++counter;
}

template <typename Function>
Function next_of(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* memory, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
void __libc_free(void* memory);

void* malloc(std::size_t bytes) {
    note(allocations);
    return __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
    note(allocations);
    return __libc_calloc(count, bytes);
}
void* realloc(void* memory, std::size_t bytes) {
    note(allocations);
    return __libc_realloc(memory, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
    note(allocations);
    return __libc_memalign(alignment, bytes);
}
void free(void* memory) {
    note(allocations);
    __libc_free(memory);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) {
    static const auto next = next_of<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
    note(locks);
    return next(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) {
    static const auto next = next_of<int (*)(pthread_mutex_t*)>("pthread_mutex_trylock");
    note(locks);
    return next(mutex);
}
}

namespace psicarve::cycle {
namespace {

struct Counts {
    std::uint64_t allocations = 0;
    std::uint64_t locks = 0;
    std::uint64_t page_faults = 0;
};

std::uint64_t page_faults_so_far() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return static_cast<std::uint64_t>(usage.ru_minflt + usage.ru_majflt);
}

/// Counts what `work` does in this thread.
template <typename Work>
void count_into(Counts& counts, Work&& work) {
    allocations = 0;
    locks = 0;
    const std::uint64_t faults_before = page_faults_so_far();
    is_counting = true;
    work();
    is_counting = false;
    counts.page_faults += page_faults_so_far() - faults_before;
    counts.allocations += allocations;
    counts.locks += locks;
}

void expect_nothing(const Counts& counts) {
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
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
    void drain() {
        Report report;
        while (rig_->io->reports.pop_into(report)) {
        }
        IncrementEntry entry;
        while (rig_->io->increments.pop_into(entry)) {
        }
    }
    std::unique_ptr<MachineRig> rig_;
};

TEST_F(TickCounts, TheCountersCount) {
    Counts counts;
    count_into(counts, [] {
        pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
        pthread_mutex_lock(&mutex);
        pthread_mutex_unlock(&mutex);
        const auto text = std::make_unique<std::string>(100, 'x');
        auto* volatile page = static_cast<char*>(std::malloc(std::size_t{64} << 20));
        for (std::size_t at = 0; at < std::size_t{64} << 20; at += 4096) page[at] = text->front();
        std::free(page);
    });
    EXPECT_EQ(counts.locks, 1U);
    EXPECT_GE(counts.allocations, 6U);
    EXPECT_GT(counts.page_faults, 0U);
}

TEST_F(TickCounts, NothingInAMillionTicksOnTheVirtualClock) {
    for (const Planner planner : {Planner::lookahead, Planner::angle}) {
        ASSERT_NO_FATAL_FAILURE(start(planner));
        Counts counts;
        for (int tick = 0; tick < 500'000; ++tick) {
            if (rig_->planner->wants_poll()) rig_->planner->poll();
            count_into(counts, [&] { rig_->cycle->tick(); });
            if (tick % 64 == 0) drain();
        }
        expect_nothing(counts);
        // They were worth it: it has carved.
        EXPECT_GT(rig_->cycle->sample().points_done, 1000U);
    }
}

TEST_F(TickCounts, NothingInTheLoopOnTheRealClock) {
    ASSERT_NO_FATAL_FAILURE(start(Planner::lookahead));
    constexpr std::uint64_t kTicks = 50'000;
    std::atomic<bool> is_over{false};
    Counts counts;
    rtcore::PeriodicStats stats;
    std::thread base{[&] {
        rtcore::set_up_realtime_thread(rtcore::kTickPriority);
        rtcore::RealClock clock;
        std::uint64_t ticks = 0;
        count_into(counts, [&] {
            rtcore::run_periodic(clock, {.period_ns = 50'000}, stats,
                                 [&](const rtcore::PeriodicTick& tick) noexcept {
                                     if (tick.missed_before > 0)
                                         rig_->cycle->advance_missed(tick.missed_before);
                                     rig_->cycle->tick();
                                     return ++ticks < kTicks;
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
    expect_nothing(counts);
    EXPECT_EQ(stats.report().ticks_run, kTicks);
}

}  // namespace
}  // namespace psicarve::cycle
