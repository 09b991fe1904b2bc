// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/fatal_signals.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "rtcore/process/handler_stack.hpp"
#include "shared/profile/profile.hpp"

namespace {

// What a port takes in the child; the parent sees it.
std::atomic<int>* g_writes = nullptr;
constexpr int kPort = 999;

}  // namespace

// Before the C library's: descriptor kPort is a port.
extern "C" int ioctl(int descriptor, unsigned long /*request*/, ...) noexcept {
    if (descriptor != kPort || g_writes == nullptr) return -1;
    g_writes->fetch_add(1);
    return 0;
}

namespace psicarve::port {
namespace {

class FatalSignals : public ::testing::Test {
protected:
    FatalSignals() {
        g_writes = static_cast<std::atomic<int>*>(
            mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    }
    ~FatalSignals() override { munmap(g_writes, sizeof(int)); }

    /// In a process of its own that watches over a port: the signal that ended it.
    template <typename Work>
    int signal_that_ends(Work work) {
        g_writes->store(0);
        const pid_t child = fork();
        if (child == 0) {
            const rlimit no_core{0, 0};
            setrlimit(RLIMIT_CORE, &no_core);
            handle_fatal_signals();
            watch_over(SafeState{PortAccess::ppdev(kPort), PinMap::from_profile(Profile{}).value()});
            work();
            _exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }
    static constexpr int kWritesOfTwoSafeStates = 4;
};

TEST_F(FatalSignals, EachThatWouldEndTheProcessWritesTheSafeStateAndEndsIt) {
    for (int number = 1; number <= SIGRTMAX; ++number) {
        struct sigaction before {};
        const bool is_the_librarys = sigaction(number, nullptr, &before) != 0;
        const bool is_for_others = number == SIGINT || number == SIGTERM || number == SIGHUP ||
                                   number == SIGPIPE || number == SIGXFSZ || number == SIGKILL;
        const bool ends_nobody = number == SIGCHLD || number == SIGCONT || number == SIGURG ||
                                 number == SIGWINCH || number == SIGSTOP || number == SIGTSTP ||
                                 number == SIGTTIN || number == SIGTTOU;
        if (is_the_librarys || is_for_others || ends_nobody) continue;
        EXPECT_EQ(signal_that_ends([number] { raise(number); }), number);
        EXPECT_EQ(g_writes->load(), kWritesOfTwoSafeStates) << "signal " << number;
    }
}

int dive(volatile int* above) {
    volatile int here[1024];
    here[0] = *above;
    if (here[0] < 0) return 0;
    return dive(here) + here[0];
}

TEST_F(FatalSignals, AStackThatIsFullIsOne) {
    const auto overflow = [] {
        std::thread{[] {
            const rtcore::HandlerStack handler_stack;
            volatile int top = 0;
            dive(&top);
        }}.join();
    };
    EXPECT_EQ(signal_that_ends(overflow), SIGSEGV);
    EXPECT_EQ(g_writes->load(), kWritesOfTwoSafeStates);
}

}  // namespace
}  // namespace psicarve::port
