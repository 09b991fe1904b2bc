// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/guard/guard.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

#include "rtcore/guard/dying.hpp"
#include "rtcore/guard/last_words.hpp"

namespace psicarve::guard {
namespace {

constexpr int kLook_ms = 20;
constexpr int kSilentLooks = 25;  ///< in a row without a tick: counted, so that a suspended computer is none
constexpr int kSafeTries = 5;
constexpr int kSignalExitBase = 128;

Error error_of(const char* what) {
    return Error{ErrorCode::no_core, std::string{"the guard cannot begin: "} + what + ": " +
                                         std::generic_category().message(errno)};
}

bool write_safe_state(const port::SafeState& safe_state) noexcept {
    for (int i = 0; i < kSafeTries; ++i) {
        if (safe_state.write()) return true;
    }
    return false;
}

/// Orders to end, which go on to the core.
sigset_t orders_to_end() {
    sigset_t orders;
    sigemptyset(&orders);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&orders, number);
    return orders;
}

class Guard {
public:
    Guard(GuardDuty duty, pid_t core_pid, int from_core, GuardPage page)
        : duty_(std::move(duty)), core_pid_(core_pid), from_core_(from_core), page_(std::move(page)) {}

    int run() {
        prctl(PR_SET_NAME, "psicarve-guard");
        // On a busy computer it must not wait for its turn, nor for a page from a disk. It hardly ever runs,
        // and goes on without either where they are refused.
        const sched_param lowest{.sched_priority = 1};
        static_cast<void>(sched_setscheduler(0, SCHED_FIFO, &lowest));
        static_cast<void>(mlockall(MCL_CURRENT));
        const sigset_t order_set = orders_to_end();
        const int orders = signalfd(-1, &order_set, SFD_CLOEXEC | SFD_NONBLOCK);
        while (!core_has_ended(orders)) {
            forward_orders(orders);
            watch_ticks();
        }
        return bury();
    }

private:
    /// Sleeps until something happens, or it is time to look at the ticks.
    bool core_has_ended(int orders) const noexcept {
        std::array<pollfd, 2> sources{pollfd{.fd = from_core_, .events = POLLIN, .revents = 0},
                                      pollfd{.fd = orders, .events = POLLIN, .revents = 0}};
        if (poll(sources.data(), sources.size(), kLook_ms) <= 0) return false;
        return (sources[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
    }

    void forward_orders(int orders) const noexcept {
        signalfd_siginfo order{};
        while (orders >= 0 && read(orders, &order, sizeof order) == ssize_t{sizeof order}) {
            // What the terminal sends it sends to both of us.
            const bool is_from_terminal = order.ssi_code == SI_KERNEL;
            if (!is_from_terminal) kill(core_pid_, static_cast<int>(order.ssi_signo));
        }
    }

    // A core that is stopped, or starved, puts out no pulses; but a spindle turns on.
    void watch_ticks() noexcept {
        const std::uint64_t ticks = page_.ticks();
        const bool is_silent = page_.is_ticking() && ticks == ticks_seen_;
        ticks_seen_ = ticks;
        silent_looks_ = is_silent ? silent_looks_ + 1 : 0;
        // Its pipe closes once its memory is given back; a spindle need not turn for so long.
        if (is_silent && is_dying(core_pid_)) write_safe_state(duty_.safe_state);
        if (silent_looks_ != kSilentLooks) return;
        const bool is_safe = write_safe_state(duty_.safe_state);
        page_.note_act();
        std::fprintf(stderr, "psicarve-rtcore: guard: the core (pid %d) does not tick any more; %s\n",
                     static_cast<int>(core_pid_), outcome(is_safe));
    }

    int bury() {
        int status = 0;
        while (waitpid(core_pid_, &status, 0) < 0 && errno == EINTR) {
        }
        // It has made the port safe itself.
        if (WIFEXITED(status)) return WEXITSTATUS(status);
        const bool is_safe = write_safe_state(duty_.safe_state);
        const int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        leave_last_words(duty_.segment_name, duty_.group, static_cast<std::uint32_t>(core_pid_));
        std::fprintf(stderr, "psicarve-rtcore: guard: the core (pid %d) was ended by signal %d (%s); %s\n",
                     static_cast<int>(core_pid_), number, strsignal(number), outcome(is_safe));
        return kSignalExitBase + number;
    }

    static const char* outcome(bool is_safe) noexcept {
        return is_safe ? "drives and spindle are switched off"
                       : "the port does not answer: switch the machine off by its own switch";
    }

    GuardDuty duty_;
    pid_t core_pid_;
    int from_core_;
    GuardPage page_;
    std::uint64_t ticks_seen_ = 0;
    int silent_looks_ = 0;
};

}  // namespace

Result<std::variant<GuardLink, int>> part_from_guard(const GuardDuty& duty) {
    auto page = GuardPage::make();
    if (!page) return page.error();
    std::array<int, 2> to_core{-1, -1};
    std::array<int, 2> to_guard{-1, -1};
    if (pipe2(to_core.data(), O_CLOEXEC) != 0) return error_of("pipe");
    if (pipe2(to_guard.data(), O_CLOEXEC) != 0) {
        const Error error = error_of("pipe");
        for (const int end : to_core) close(end);
        return error;
    }
    // A terminal's Ctrl-Z would leave the spindle running.
    for (const int number : {SIGTSTP, SIGTTIN, SIGTTOU}) signal(number, SIG_IGN);
    // An order that comes now waits until there is somebody to take it.
    const sigset_t order_set = orders_to_end();
    sigset_t before;
    sigprocmask(SIG_BLOCK, &order_set, &before);
    std::fflush(nullptr);
    const pid_t pid = fork();
    if (pid <= 0) sigprocmask(SIG_SETMASK, &before, nullptr);
    if (pid < 0) {
        const Error error = error_of("fork");
        for (const int end : {to_core[0], to_core[1], to_guard[0], to_guard[1]}) close(end);
        return error;
    }
    if (pid == 0) {
        close(to_core[1]);
        close(to_guard[0]);
        return std::variant<GuardLink, int>{GuardLink{to_core[0], to_guard[1], std::move(*page)}};
    }
    close(to_core[0]);
    close(to_guard[1]);
    const int exit_code = Guard{duty, pid, to_guard[0], std::move(*page)}.run();
    close(to_core[1]);
    close(to_guard[0]);
    return std::variant<GuardLink, int>{exit_code};
}

}  // namespace psicarve::guard
