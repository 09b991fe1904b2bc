// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/rt_setup.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "shared/computer/cpu_list.hpp"

namespace psicarve::rtcore {
namespace {

constexpr std::size_t kStackBytes = std::size_t{256} * 1024;
constexpr std::size_t kHeapBytes = std::size_t{8} << 20;
/// More address space than the core ever maps at once: two job slots of the largest capacity.
constexpr std::size_t kProbeBytes = std::size_t{1} << 30;

SetupStep done(RealtimeStep step, std::string detail) {
    return {.step = step, .outcome = SetupStep::Outcome::done, .detail = std::move(detail), .remedy = {}};
}
SetupStep refused(RealtimeStep step, int error) {
    return {.step = step,
            .outcome = SetupStep::Outcome::refused,
            .detail = std::generic_category().message(error),
            .remedy = std::string{remedy_of(step)}};
}

SetupStep keep_heap() {
    // Memory once obtained is never handed back, and no allocation becomes a mapping of its own: neither
    // page faults nor system calls come back later.
    if (mallopt(M_TRIM_THRESHOLD, -1) == 1 && mallopt(M_MMAP_MAX, 0) == 1) {
        return done(RealtimeStep::keep_heap, "heap kept");
    }
    return refused(RealtimeStep::keep_heap, ENOTSUP);
}

/// With MCL_FUTURE every later mapping counts against the limit: is there room for the segment?
bool can_map_more() noexcept {
    void* const probe = mmap(nullptr, kProbeBytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (probe == MAP_FAILED) return false;
    munmap(probe, kProbeBytes);
    return true;
}

SetupStep lock_memory() {
    if (mlockall(MCL_CURRENT) != 0) return refused(RealtimeStep::lock_memory, errno);
    // ONFAULT: the segment is sparse; locking it whole would allocate all it might ever hold.
    if (mlockall(MCL_FUTURE | MCL_ONFAULT) != 0) {
        const int error = errno;
        munlockall();
        return refused(RealtimeStep::lock_memory, error);
    }
    if (!can_map_more()) {
        munlockall();
        return refused(RealtimeStep::lock_memory, ENOMEM);
    }
    return done(RealtimeStep::lock_memory, "memory locked");
}

[[gnu::noinline]] void touch_stack() noexcept {
    char pages[kStackBytes];
    std::memset(pages, 0, sizeof pages);
    // Keeps the compiler from noticing that no code reads it.
    asm volatile("" : : "r"(pages) : "memory");
}

SetupStep keep_to_cpu(std::optional<int> cpu) {
    if (!cpu) {
        return {.step = RealtimeStep::tick_cpu,
                .outcome = SetupStep::Outcome::not_asked,
                .detail = "any processor",
                .remedy = {}};
    }
    cpu_set_t one;
    CPU_ZERO(&one);
    if (*cpu < 0 || *cpu >= CPU_SETSIZE) return refused(RealtimeStep::tick_cpu, EINVAL);
    CPU_SET(*cpu, &one);
    const int error = pthread_setaffinity_np(pthread_self(), sizeof one, &one);
    if (error != 0) return refused(RealtimeStep::tick_cpu, error);
    return done(RealtimeStep::tick_cpu, "processor " + std::to_string(*cpu));
}

SetupStep schedule_at(int priority) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
    if (error != 0) return refused(RealtimeStep::scheduling, error);
    return done(RealtimeStep::scheduling, "SCHED_FIFO, priority " + std::to_string(priority));
}

}  // namespace

std::vector<SetupStep> set_up_process_memory() {
    std::vector<SetupStep> steps;
    steps.push_back(keep_heap());
    steps.push_back(lock_memory());
    return steps;
}

SetupStep touch_heap() {
    void* const reserve = std::malloc(kHeapBytes);
    if (reserve == nullptr) return refused(RealtimeStep::touch_memory, ENOMEM);
    touch_pages(reserve, kHeapBytes);
    std::free(reserve);
    std::ifstream maps{"/proc/self/maps"};
    for (std::string line; std::getline(maps, line);) {
        void* begin = nullptr;
        void* end = nullptr;
        if (!line.ends_with("[heap]") || std::sscanf(line.c_str(), "%p-%p", &begin, &end) != 2) continue;
        const auto* const first = static_cast<const char*>(begin);
        touch_pages(begin, static_cast<std::size_t>(static_cast<const char*>(end) - first));
    }
    return done(RealtimeStep::touch_memory, "memory touched");
}

namespace {

// Exchanges a byte for itself, in one piece: unlike a read it makes the page, unlike a store it cannot undo
// another thread's write. Or-ing with nothing would do the same, but Clang makes a read of it.
[[gnu::no_sanitize_address]] void write_back(unsigned char* byte) noexcept {
    unsigned char value = __atomic_load_n(byte, __ATOMIC_RELAXED);
    __atomic_compare_exchange_n(byte, &value, value, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
}

}  // namespace

// Also touches unused memory, which a sanitizer would not allow.
[[gnu::no_sanitize_address]] void touch_pages(void* begin, std::size_t bytes) noexcept {
    const auto page_bytes = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    auto* const first = static_cast<unsigned char*>(begin);
    for (std::size_t at = 0; at < bytes; at += page_bytes) write_back(first + at);
    if (bytes > 0) write_back(first + bytes - 1);
}

bool has_realtime_kernel(const std::string& root) {
    std::string realtime;
    std::string version;
    std::getline(std::ifstream{root + "/sys/kernel/realtime"}, realtime);
    std::getline(std::ifstream{root + "/proc/version"}, version);
    return is_realtime_kernel(realtime, version);
}

std::optional<int> isolated_cpu(const std::string& root) {
    std::ifstream file{root + "/sys/devices/system/cpu/isolated"};
    std::string text;
    std::getline(file, text);
    const auto isolated = cpus_from_list(text);
    if (!isolated || isolated->empty() || isolated->back() >= CPU_SETSIZE) return std::nullopt;
    return isolated->back();
}

void keep_off_cpu(int cpu) noexcept {
    cpu_set_t allowed;
    if (cpu < 0 || cpu >= CPU_SETSIZE || sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    CPU_CLR(cpu, &allowed);
    if (CPU_COUNT(&allowed) > 0) sched_setaffinity(0, sizeof allowed, &allowed);
}

std::vector<SetupStep> set_up_realtime_thread(int priority, std::optional<int> cpu) {
    touch_stack();
    std::vector<SetupStep> steps;
    steps.push_back(keep_to_cpu(cpu));
    steps.push_back(schedule_at(priority));
    return steps;
}

WakeLatencyHold::~WakeLatencyHold() {
    if (descriptor_ >= 0) close(descriptor_);
}

SetupStep WakeLatencyHold::hold(const char* path) {
    if (descriptor_ < 0) descriptor_ = open(path, O_WRONLY | O_CLOEXEC);
    const std::int32_t most_us = 0;
    if (descriptor_ < 0 || write(descriptor_, &most_us, sizeof most_us) != sizeof most_us) {
        const int error = errno;
        SetupStep step = refused(RealtimeStep::wake_latency, error);
        if (error == ENOENT) step.remedy = kNoLatencyDeviceRemedy;
        return step;
    }
    return done(RealtimeStep::wake_latency, "processors kept awake");
}

std::uint32_t steps_asked(std::span<const SetupStep> steps) noexcept {
    std::uint32_t bits = 0;
    for (const SetupStep& step : steps) {
        if (step.outcome != SetupStep::Outcome::not_asked) bits |= bit_of(step.step);
    }
    return bits;
}

std::uint32_t steps_done(std::span<const SetupStep> steps) noexcept {
    std::uint32_t bits = 0;
    for (const SetupStep& step : steps) {
        if (step.outcome == SetupStep::Outcome::done) bits |= bit_of(step.step);
    }
    return bits;
}

std::vector<std::string> report_of(std::span<const SetupStep> steps) {
    std::string in_force;
    std::vector<std::string> lines;
    for (const SetupStep& step : steps) {
        if (step.outcome == SetupStep::Outcome::refused) {
            lines.push_back(std::string{name_of(step.step)} + ": refused: " + step.detail + "; " +
                            step.remedy);
        } else {
            in_force += (in_force.empty() ? "" : ", ") + step.detail;
        }
    }
    lines.insert(lines.begin(), "real time: " + (in_force.empty() ? "nothing is in force" : in_force));
    return lines;
}

}  // namespace psicarve::rtcore
