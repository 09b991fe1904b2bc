// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <utility>

namespace psicarve::test {

/// A second process that runs a function of the test and can be stopped or killed at any instant. Killed at
/// the end at the latest; dies with the test program.
class ChildProcess {
public:
    /// Says to the test that the child has come to a certain place.
    class Signal {
    public:
        explicit Signal(int descriptor) : descriptor_(descriptor) {}
        void raise() const { (void)!::write(descriptor_, "x", 1); }

    private:
        int descriptor_;
    };

    template <typename Work>
    explicit ChildProcess(Work work) {
        int ends[2] = {-1, -1};
        if (::pipe(ends) != 0) ADD_FAILURE() << "no pipe";
        pid_ = ::fork();
        if (pid_ == 0) {
            ::prctl(PR_SET_PDEATHSIG, SIGKILL);
            ::close(ends[0]);
            work(Signal{ends[1]});
            ::_exit(testing::Test::HasFailure() ? 1 : 0);
        }
        ::close(ends[1]);
        read_end_ = ends[0];
    }
    ~ChildProcess() {
        kill();
        if (read_end_ >= 0) ::close(read_end_);
    }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    std::uint32_t pid() const { return static_cast<std::uint32_t>(pid_); }
    /// False when the child ended without raising it.
    bool wait_for_signal() const {
        char byte = 0;
        return ::read(read_end_, &byte, 1) == 1;
    }
    void send(int signal_number) const { ::kill(pid_, signal_number); }
    /// Returns when it is stopped.
    void stop() const {
        send(SIGSTOP);
        ::waitpid(pid_, nullptr, WUNTRACED);
    }
    /// SIGKILL; returns when it is dead and buried.
    void kill() {
        if (is_over_) return;
        send(SIGKILL);
        ::waitpid(pid_, nullptr, 0);
        is_over_ = true;
    }
    /// Waits for its own end; negative when a signal ended it.
    int exit_code() {
        int status = -1;
        ::waitpid(pid_, &status, 0);
        is_over_ = true;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// Waits for its own end: whether all it checked was right.
    bool ends_well() { return exit_code() == 0; }

private:
    pid_t pid_ = -1;
    int read_end_ = -1;
    bool is_over_ = false;
};

}  // namespace psicarve::test
