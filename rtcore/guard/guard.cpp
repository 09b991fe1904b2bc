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
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "rtcore/guard/dying.hpp"
#include "rtcore/guard/last_words.hpp"
#include "rtcore/port/persistence.hpp"
#include "rtcore/process/privileges.hpp"
#include "rtcore/process/words.hpp"

namespace psicarve::guard {
namespace {

constexpr int kLook_ms = 20;
constexpr int kSilentLooks = 25;  ///< in a row without a tick: counted, so that a suspended computer does not
                                  ///< count
constexpr int kSafeTries = 5;
/// For a port that does not take the safe state when the core is gone.
constexpr std::chrono::minutes kPatience{10};
constexpr int kExitUnsafe = 4;
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

/// Orders to end, which go on to the core. SIGQUIT: it writes the safe state and dies.
sigset_t orders_to_end() {
    sigset_t orders;
    sigemptyset(&orders);
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&orders, number);
    return orders;
}

/// Of these only a fault of its own ends a guard: otherwise the core would have no guard.
sigset_t other_signals() {
    sigset_t others;
    sigfillset(&others);
    const sigset_t orders = orders_to_end();
    for (int number = 1; number <= SIGRTMAX; ++number) {
        if (sigismember(&orders, number) == 1) sigdelset(&others, number);
    }
    for (const int number : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTRAP, SIGSYS, SIGCHLD})
        sigdelset(&others, number);
    return others;
}

/// Those that came while they were held back are gone.
void ignore_other_signals() {
    const sigset_t others = other_signals();
    for (int number = 1; number <= SIGRTMAX; ++number) {
        if (sigismember(&others, number) == 1) signal(number, SIG_IGN);
    }
    sigprocmask(SIG_UNBLOCK, &others, nullptr);
}

class Guard {
public:
    Guard(GuardDuty duty, pid_t core_pid, int from_core, GuardPage page)
        : duty_(std::move(duty)),
          core_pid_(core_pid),
          from_core_(from_core),
          page_(std::move(page)),
          core_end_(core_pid) {}

    int run() {
        prctl(PR_SET_NAME, "psicarve-guard");
        ignore_other_signals();
        // On a busy computer the guard must not wait for its turn, nor for a page from a disk. It hardly ever
        // runs, and goes on without either where they are refused.
        const sched_param lowest{.sched_priority = 1};
        static_cast<void>(sched_setscheduler(0, SCHED_FIFO, &lowest));
        static_cast<void>(mlockall(MCL_CURRENT));
        static_cast<void>(
            rtcore::drop_privileges({.priority = 0, .locks_memory = false, .group = duty_.group}));
        const sigset_t order_set = orders_to_end();
        orders_ = signalfd(-1, &order_set, SFD_CLOEXEC | SFD_NONBLOCK);
        while (!core_has_ended()) {
            forward_orders();
            watch_ticks();
            page_.note_look();
        }
        return reap_core();
    }

private:
    /// Sleeps until something happens, or it is time to look at the ticks.
    bool core_has_ended() const noexcept {
        std::array<pollfd, 2> sources{pollfd{.fd = from_core_, .events = POLLIN, .revents = 0},
                                      pollfd{.fd = orders_, .events = POLLIN, .revents = 0}};
        if (poll(sources.data(), sources.size(), kLook_ms) <= 0) return false;
        return (sources[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
    }

    /// The next one's number; 0 when there is none.
    int take_order() const noexcept {
        signalfd_siginfo order{};
        const bool is_order = orders_ >= 0 && read(orders_, &order, sizeof order) == ssize_t{sizeof order};
        return is_order ? static_cast<int>(order.ssi_signo) : 0;
    }

    void forward_orders() noexcept {
        while (const int number = take_order()) {
            note_order();
            kill(core_pid_, number);
        }
    }

    // An order that comes after the guard has said that it goes on trying, with a core that ends anyway, is
    // meant for the guard: a second one is not needed.
    void note_order() noexcept { is_released_ = is_released_ || (has_ticked_ && is_silence_said_); }

    // A core that is stopped, or starved, emits no pulses; but its spindle turns on.
    void watch_ticks() noexcept {
        const std::uint64_t ticks = page_.ticks();
        const bool is_ticking = page_.is_ticking();
        const bool is_silent = is_ticking && ticks == ticks_seen_;
        ticks_seen_ = ticks;
        watch_end(is_ticking);
        silent_looks_ = is_silent ? silent_looks_ + 1 : 0;
        if (owes_safe_state_) repay(is_silent || has_ticked_);
        // The core's pipe closes only when its memory is given back; the spindle need not turn that long.
        if (is_silent && core_end_.is_dying()) write_safe_state(duty_.safe_state);
        if (silent_looks_ != kSilentLooks) return;
        // First: a core that comes back meanwhile must not write its old levels after us.
        page_.note_act();
        const bool is_safe = write_safe_state(duty_.safe_state);
        owes_safe_state_ = !is_safe;
        say_outcome("the core (pid " + std::to_string(core_pid_) + ") does not tick any more; ", is_safe);
    }

    // A core that has put out its last tick may still have traces to end, and does not look after the port.
    void watch_end(bool is_ticking) noexcept {
        if (was_ticking_ && !is_ticking) {
            owes_safe_state_ = !write_safe_state(duty_.safe_state);
            forward_orders();  // their senders have not read yet what is said now
            has_ticked_ = true;
            if (owes_safe_state_) {
                say_outcome("", false);
            } else if (is_silence_said_) {
                say_it_answers();
            }
        }
        was_ticking_ = is_ticking;
    }

    // A core that ticks again writes it itself: it has an alarm. Whether the port answers by then the guard
    // does not learn.
    void repay(bool is_ours) noexcept {
        owes_safe_state_ = is_ours && !duty_.safe_state.write();
        if (!is_ours) return try_to_say("the core ticks again: from now on it tries itself");
        if (!owes_safe_state_) say_it_answers();
    }

    int reap_core() {
        int status = 0;
        while (waitpid(core_pid_, &status, 0) < 0 && errno == EINTR) {
        }
        // A core that ended in order has made the port safe itself; the guard checks that instead of trusting
        // it.
        const bool is_safe = write_safe_state(duty_.safe_state);
        int exit_code = WEXITSTATUS(status);
        std::string event;
        if (WIFEXITED(status)) {
            // Also where the core has made the port answer, which the guard does not learn.
            if (is_safe && is_silence_said_) say_it_answers();
            if (is_safe) return exit_code;
        } else {
            const int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
            exit_code = kSignalExitBase + number;
            leave_words(is_safe);
            event = "the core (pid " + std::to_string(core_pid_) + ") was ended by signal " +
                    std::to_string(number) + " (" + strsignal(number) + "); ";
        }
        while (take_order() != 0) note_order();
        say_outcome(event, is_safe);
        if (is_safe) return exit_code;
        if (!persist()) return exit_code == 0 ? kExitUnsafe : exit_code;
        say_it_answers();
        leave_words(true);
        return exit_code;
    }

    /// An order that comes during this is meant for the guard: there is no core any more.
    bool persist() const {
        return port::write_until_taken(duty_.safe_state, kPatience,
                                       [&] { return is_released_ || take_order() != 0; });
    }

    void leave_words(bool is_safe) const {
        leave_last_words(duty_.segment_name, duty_.group, static_cast<std::uint32_t>(core_pid_), is_safe);
    }
    // A line that cannot be written at once is dropped: the port comes first.
    static void try_to_say(const std::string& text) noexcept { rtcore::try_to_say("guard: " + text); }
    void say_outcome(const std::string& event, bool is_safe) noexcept {
        is_silence_said_ = !is_safe;
        if (is_safe) is_released_ = false;
        try_to_say(event + outcome(is_safe));
    }
    void say_it_answers() noexcept { say_outcome("the port answers again; ", true); }
    std::string outcome(bool is_safe) const {
        if (is_safe) return "drives and spindle are switched off";
        return std::string{"the port does not answer: switch the machine off by its own switch; "} +
               (is_released_ ? "the guard ends, as it was ordered to" : "the guard goes on trying");
    }

    GuardDuty duty_;
    pid_t core_pid_;
    int from_core_;
    int orders_ = -1;  ///< signals, to be read
    GuardPage page_;
    DyingWatch core_end_;
    std::uint64_t ticks_seen_ = 0;
    int silent_looks_ = 0;
    bool owes_safe_state_ = false;  ///< the port has not taken it
    bool is_silence_said_ = false;  ///< said that the port does not answer, and not yet that it does again
    bool was_ticking_ = false;
    bool has_ticked_ = false;   ///< and will not tick any more
    bool is_released_ = false;  ///< by an order that was meant for the guard
};

}  // namespace

Result<std::variant<GuardLink, int>> fork_guard(const GuardDuty& duty) {
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
    // A terminal's Ctrl-Z would leave the spindle running; and words need not be read.
    for (const int number : {SIGTSTP, SIGTTIN, SIGTTOU, SIGPIPE}) signal(number, SIG_IGN);
    // An order that comes now waits until one of the two processes can take it; and no other signal ends a
    // guard that does not ignore them yet.
    const sigset_t order_set = orders_to_end();
    const sigset_t others = other_signals();
    sigset_t before;
    sigprocmask(SIG_BLOCK, &order_set, &before);
    sigprocmask(SIG_BLOCK, &others, nullptr);
    std::fflush(nullptr);
    const pid_t pid = fork();
    if (pid <= 0) sigprocmask(SIG_SETMASK, &before, nullptr);
    if (pid < 0) {
        const Error error = error_of("fork");
        for (const int end : {to_core[0], to_core[1], to_guard[0], to_guard[1]}) close(end);
        return error;
    }
    if (pid == 0) {
        // A signal that kills a terminal's job or a shell's process group as a whole kills the guard, and the
        // core switches off.
        setpgid(0, 0);
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
