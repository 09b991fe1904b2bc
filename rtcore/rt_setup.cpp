// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/rt_setup.hpp"

#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <system_error>

namespace psicarve::rtcore {
namespace {

constexpr std::size_t kStackBytes = std::size_t{256} * 1024;
/// More address space than the core ever maps at once: two job slots of the largest capacity.
constexpr std::size_t kProbeBytes = std::size_t{1} << 30;

SetupStep done(std::string name, std::string detail) {
    return {.name = std::move(name), .ok = true, .detail = std::move(detail), .remedy = {}};
}
SetupStep refused(std::string name, int error, std::string remedy) {
    return {.name = std::move(name),
            .ok = false,
            .detail = std::generic_category().message(error),
            .remedy = std::move(remedy)};
}

SetupStep keep_heap() {
    // Memory once obtained is never handed back, and no allocation becomes a mapping of its own: neither
    // page faults nor system calls come back later.
    if (mallopt(M_TRIM_THRESHOLD, -1) == 1 && mallopt(M_MMAP_MAX, 0) == 1) {
        return done("keep heap", "freed memory stays with the process");
    }
    return refused("keep heap", ENOTSUP, "use the GNU C library's allocator");
}

/// With MCL_FUTURE every later mapping counts against the limit: is there room for the segment?
bool can_map_more() noexcept {
    void* const probe = mmap(nullptr, kProbeBytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (probe == MAP_FAILED) return false;
    munmap(probe, kProbeBytes);
    return true;
}

SetupStep lock_memory() {
    const char* const remedy =
        "raise the limit: a line \"@GROUP - memlock unlimited\" in /etc/security/limits.d, or CAP_IPC_LOCK";
    if (mlockall(MCL_CURRENT) != 0) return refused("lock memory", errno, remedy);
    // ONFAULT: the segment is sparse; locking it whole would allocate all it might ever hold.
    if (mlockall(MCL_FUTURE | MCL_ONFAULT) != 0) return refused("lock memory", errno, remedy);
    if (!can_map_more()) {
        munlockall();
        return refused("lock memory", ENOMEM, remedy);
    }
    return done("lock memory", "present pages locked, later ones when first touched");
}

[[gnu::noinline]] void touch_stack() noexcept {
    char pages[kStackBytes];
    std::memset(pages, 0, sizeof pages);
    // Keeps the compiler from seeing that nobody reads it.
    asm volatile("" : : "r"(pages) : "memory");
}

}  // namespace

std::vector<SetupStep> set_up_process_memory() {
    return {keep_heap(), lock_memory()};
}

std::vector<SetupStep> set_up_realtime_thread(int priority) {
    std::vector<SetupStep> steps;
    touch_stack();
    steps.push_back(done("touch stack", std::to_string(kStackBytes / 1024) + " KiB"));
    sched_param parameters{};
    parameters.sched_priority = priority;
    const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
    if (error == 0) {
        steps.push_back(done("real-time scheduling", "SCHED_FIFO, priority " + std::to_string(priority)));
    } else {
        steps.push_back(refused("real-time scheduling", error,
                                "allow it: a line \"@GROUP - rtprio 99\" in /etc/security/limits.d, or "
                                "CAP_SYS_NICE"));
    }
    return steps;
}

bool all_ok(std::span<const SetupStep> steps) noexcept {
    return std::all_of(steps.begin(), steps.end(), [](const SetupStep& step) { return step.ok; });
}

}  // namespace psicarve::rtcore
