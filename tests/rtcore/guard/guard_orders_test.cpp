// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "rtcore/guard/guard.hpp"
#include "rtcore/port/port_access.hpp"
#include "shared/profile/pin_map.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::guard {
namespace {

constexpr int kUnsafe = 4;       ///< the guard's exit code where the machine must not count as safe
constexpr int kPatience_s = 30;  ///< with a process that a busy computer keeps waiting
constexpr const char* kIsSilent = "guard: the port does not answer";
constexpr const char* kGoesOnTrying = "the guard goes on trying";

/// A guard of a port that never answers, and a core that does step by step what is asked of it: `tick` until
/// the guard has seen that it does, `beats` ticks with pauses for two seconds, `last_tick`, `order` waits for
/// one, `end`.
class GuardOrders : public testing::Test {
protected:
    GuardOrders() {
        for (auto* const pipe : {&words_, &steps_, &done_}) EXPECT_EQ(pipe2(pipe->data(), O_CLOEXEC), 0);
        guard_ = fork();
        if (guard_ == 0) be_guard_and_core();
        close(std::exchange(words_[1], -1));
        close(std::exchange(done_[1], -1));
    }
    ~GuardOrders() override {
        if (guard_ > 0) {
            kill(guard_, SIGKILL);
            waitpid(guard_, nullptr, 0);
        }
        for (const auto* const pipe : {&words_, &steps_, &done_}) {
            for (const int end : *pipe) close(end);
        }
    }
    GuardOrders(const GuardOrders&) = delete;
    GuardOrders& operator=(const GuardOrders&) = delete;

    enum class Step : char { tick = 't', beats = 'b', last_tick = 'l', order = 'o', end = 'e', failed = 'f' };

    /// False: the core has not done it in time.
    bool core_does(Step step, int patience_s = kPatience_s) {
        Step done{};
        return write(steps_[1], &step, 1) == 1 && has_something(done_[0], patience_s) &&
               read(done_[0], &done, 1) == 1 && done == step;
    }
    bool guard_says(const std::string& words) {
        while (said_.find(words) == std::string::npos) {
            std::array<char, 512> part{};
            if (!has_something(words_[0])) return false;
            const ssize_t size = read(words_[0], part.data(), part.size());
            if (size <= 0) return false;
            said_.append(part.data(), static_cast<std::size_t>(size));
        }
        said_.erase(0, said_.find(words) + words.size());
        return true;
    }
    /// -1: it goes on.
    int exit_code_within(std::chrono::milliseconds patience) {
        const auto latest = std::chrono::steady_clock::now() + patience;
        int status = 0;
        while (waitpid(guard_, &status, WNOHANG) == 0) {
            if (std::chrono::steady_clock::now() > latest) return -1;
            std::this_thread::sleep_for(std::chrono::milliseconds{2});
        }
        guard_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -2;
    }
    pid_t guard() const { return guard_; }

private:
    static bool has_something(int from, int patience_s = kPatience_s) {
        pollfd source{.fd = from, .events = POLLIN, .revents = 0};
        return poll(&source, 1, patience_s * 1000) == 1;
    }

    /// Whether the guard lets a core be that ticks every tenth of a second: five of its looks, where it acts
    /// after 25 without a tick. Where the computer took longer between two ticks the guard may be right.
    static bool is_left_alone(GuardLink& link) {
        using Clock = std::chrono::steady_clock;
        using std::chrono::milliseconds;
        constexpr int kBeats = 20;
        bool was_late = true;
        while (was_late) {
            was_late = false;
            // What was to be done of the pauses before has been done.
            std::this_thread::sleep_for(milliseconds{200});
            link.guard_has_acted();
            Clock::time_point last = Clock::now();
            Clock::time_point last_but_one = last;
            link.note_tick();
            link.set_ticking(true);
            for (int beat = 0; beat < kBeats && !was_late; ++beat) {
                std::this_thread::sleep_for(milliseconds{100});
                const bool has_acted = link.guard_has_acted();
                const Clock::time_point now = Clock::now();
                // What it acts on may have come before the last tick.
                was_late = now - last_but_one > milliseconds{400};
                if (has_acted && !was_late) return false;
                link.note_tick();
                last_but_one = std::exchange(last, now);
            }
        }
        return true;
    }

    [[noreturn]] void be_guard_and_core() {
        dup2(words_[1], STDERR_FILENO);
        // No driver of a port: each write fails.
        const port::SafeState silent{port::PortAccess::ppdev(open("/dev/null", O_WRONLY | O_CLOEXEC)),
                                     PinMap::from_profile(Profile{}).value()};
        auto side = fork_guard({.safe_state = silent, .segment_name = "none", .group = ""});
        if (!side) _exit(1);
        if (const int* const exit_code = std::get_if<int>(&*side)) _exit(*exit_code);
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        sigset_t orders;
        sigemptyset(&orders);
        sigaddset(&orders, SIGTERM);
        sigprocmask(SIG_BLOCK, &orders, nullptr);
        auto& link = std::get<GuardLink>(*side);
        Step step{};
        while (read(steps_[0], &step, 1) == 1) {
            const timespec patience{.tv_sec = kPatience_s, .tv_nsec = 0};
            if (step == Step::tick) {
                // It acts when a core that ticked does not any more: then it has seen that it did.
                link.set_ticking(true);
                while (!link.guard_has_acted()) usleep(1000);
                link.note_tick();
            }
            if (step == Step::beats && !is_left_alone(link)) step = Step::failed;
            if (step == Step::last_tick) link.set_ticking(false);
            if (step == Step::order && sigtimedwait(&orders, nullptr, &patience) != SIGTERM) _exit(2);
            if (write(done_[1], &step, 1) != 1) _exit(3);
            if (step == Step::end) _exit(0);
        }
        _exit(5);
    }

    std::array<int, 2> words_{-1, -1};
    std::array<int, 2> steps_{-1, -1};
    std::array<int, 2> done_{-1, -1};
    pid_t guard_ = -1;
    std::string said_;
};

// The core may have traces to write long after its last tick.
TEST_F(GuardOrders, OneThatComesOnceItGoesOnTryingIsMeantForItAsWellThoughTheCoreLives) {
    ASSERT_TRUE(core_does(Step::tick));
    ASSERT_TRUE(core_does(Step::last_tick));
    ASSERT_TRUE(guard_says(kIsSilent));
    ASSERT_TRUE(guard_says(kGoesOnTrying));
    kill(guard(), SIGTERM);
    ASSERT_TRUE(core_does(Step::order)) << "it is handed on";
    ASSERT_TRUE(core_does(Step::end));
    EXPECT_TRUE(guard_says("the guard ends"));
    EXPECT_EQ(exit_code_within(std::chrono::seconds{kPatience_s}), kUnsafe);
}

// A core whose ticks come with pauses is never silent for so long.
TEST_F(GuardOrders, OnlySilenceInOnePieceCounts) {
    EXPECT_TRUE(core_does(Step::beats, 10 * kPatience_s));
}

TEST_F(GuardOrders, OneThatComesBeforeIsMeantForTheCoreAlone) {
    ASSERT_TRUE(core_does(Step::tick));
    kill(guard(), SIGTERM);
    ASSERT_TRUE(core_does(Step::order));
    ASSERT_TRUE(core_does(Step::last_tick));
    ASSERT_TRUE(guard_says(kIsSilent));
    ASSERT_TRUE(guard_says(kGoesOnTrying));
    ASSERT_TRUE(core_does(Step::end));
    ASSERT_TRUE(guard_says(kGoesOnTrying)) << "with the core gone it says so again";
    EXPECT_EQ(exit_code_within(std::chrono::milliseconds{300}), -1) << "it goes on trying";
    kill(guard(), SIGTERM);
    EXPECT_EQ(exit_code_within(std::chrono::seconds{kPatience_s}), kUnsafe);
}

}  // namespace
}  // namespace psicarve::guard
