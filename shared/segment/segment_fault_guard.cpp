// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment_fault_guard.hpp"

#include <signal.h>
#include <sys/mman.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <mutex>

namespace psicarve {
namespace {

struct GuardedRange {
    std::atomic<std::uintptr_t> begin{0};  ///< 0: entry is free
    std::atomic<std::size_t> bytes{0};     ///< 0: not to be used (yet)
    std::atomic<bool> is_lost{false};
};

std::array<GuardedRange, 8> g_ranges;
struct sigaction g_former_action;
std::once_flag g_handler_installed;

/// Puts zeros of our own in place of missing pages. mmap is a plain system call on Linux and so may be used
/// in a signal handler.
bool cover_with_zeros(GuardedRange& range, std::uintptr_t begin, std::size_t bytes) noexcept {
    range.is_lost.store(true);
    void* const address = reinterpret_cast<void*>(begin);  // NOLINT(performance-no-int-to-ptr)
    return ::mmap(address, bytes, PROT_READ | PROT_WRITE,
                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0) != MAP_FAILED;
}

bool handle_in_guarded_range(std::uintptr_t fault) noexcept {
    for (GuardedRange& range : g_ranges) {
        const std::size_t bytes = range.bytes.load();
        const std::uintptr_t begin = range.begin.load();
        if (bytes != 0 && fault >= begin && fault - begin < bytes) {
            return cover_with_zeros(range, begin, bytes);
        }
    }
    return false;
}

void pass_on(int signal_number, siginfo_t* info, void* context) noexcept {
    if ((g_former_action.sa_flags & SA_SIGINFO) != 0) {
        g_former_action.sa_sigaction(signal_number, info, context);
    } else if (g_former_action.sa_handler != SIG_DFL && g_former_action.sa_handler != SIG_IGN) {
        g_former_action.sa_handler(signal_number);
    } else {
        ::sigaction(SIGBUS, &g_former_action, nullptr);  // the access is tried again and ends the process
    }
}

void on_bus_error(int signal_number, siginfo_t* info, void* context) {
    const int saved_errno = errno;
    // Only the kernel's own faults carry an address.
    const bool is_fault = info->si_code > 0;
    if (!is_fault || !handle_in_guarded_range(reinterpret_cast<std::uintptr_t>(info->si_addr))) {
        pass_on(signal_number, info, context);
    }
    errno = saved_errno;
}

void install_handler() noexcept {
    struct sigaction action {};
    action.sa_sigaction = on_bus_error;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGBUS, &action, &g_former_action);
}

}  // namespace

SegmentFaultGuard::SegmentFaultGuard(void* begin, std::size_t bytes) noexcept {
    std::call_once(g_handler_installed, install_handler);
    for (std::size_t index = 0; index < g_ranges.size(); ++index) {
        std::uintptr_t free_entry = 0;
        GuardedRange& range = g_ranges[index];
        if (!range.begin.compare_exchange_strong(free_entry, reinterpret_cast<std::uintptr_t>(begin)))
            continue;
        range.is_lost.store(false);
        range.bytes.store(bytes);
        entry_ = static_cast<int>(index);
        return;
    }
}

SegmentFaultGuard::~SegmentFaultGuard() {
    if (entry_ < 0) return;
    GuardedRange& range = g_ranges[static_cast<std::size_t>(entry_)];
    range.bytes.store(0);
    range.begin.store(0);
}

bool SegmentFaultGuard::is_lost() const noexcept {
    return entry_ >= 0 && g_ranges[static_cast<std::size_t>(entry_)].is_lost.load();
}

}  // namespace psicarve
