// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/fatal_signals.hpp"

#include <signal.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <optional>

namespace psicarve::port {
namespace {

/// Signals that EndRequest turns into an orderly end, or ignores; and those that do not end a process.
constexpr int kNotFatal[] = {SIGINT,  SIGTERM, SIGHUP,  SIGPIPE, SIGXFSZ, SIGKILL, SIGSTOP,
                             SIGTSTP, SIGTTIN, SIGTTOU, SIGCHLD, SIGCONT, SIGURG,  SIGWINCH};

// Signal handlers reach nothing but memory of static storage.
std::optional<SafeState> g_safe_state;
std::atomic<bool> g_is_watched_over{false};
std::atomic<bool> g_fatal_signal_came{false};

void write_safe_state_and_die(int signal_number) {
    g_fatal_signal_came.store(true);
    if (g_is_watched_over.load()) {
        g_safe_state->write();
        // The tick may be in the middle of a write: it begins no other, and ours is the last.
        constexpr timespec kWriteUnderWay{.tv_sec = 0, .tv_nsec = 2'000'000};
        nanosleep(&kWriteUnderWay, nullptr);
        g_safe_state->write();
    }
    signal(signal_number, SIG_DFL);
    raise(signal_number);  // comes when this handler has returned
}

}  // namespace

void handle_fatal_signals() {
    struct sigaction action {};
    action.sa_handler = write_safe_state_and_die;
    sigfillset(&action.sa_mask);
    action.sa_flags = SA_ONSTACK;
    // The C library refuses those that it reserves for itself.
    for (int number = 1; number <= SIGRTMAX; ++number) {
        if (std::ranges::find(kNotFatal, number) == std::end(kNotFatal)) sigaction(number, &action, nullptr);
    }
}

void watch_over(const std::optional<SafeState>& safe_state) noexcept {
    g_is_watched_over.store(false);
    if (!safe_state) return;
    g_safe_state = safe_state;
    g_is_watched_over.store(true);
}

bool fatal_signal_came() noexcept {
    return g_fatal_signal_came.load(std::memory_order_relaxed);
}

}  // namespace psicarve::port
