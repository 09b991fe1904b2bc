// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/ptrace.h>
#include <sys/wait.h>

#include <cerrno>

namespace psicarve::two_process {

/// One thread of another process that stands still, as a debugger stops it, while its others go on.
class StoppedThread {
public:
    explicit StoppedThread(pid_t thread) : thread_(thread) {
        if (ptrace(PTRACE_SEIZE, thread_, nullptr, nullptr) != 0) return;
        if (ptrace(PTRACE_INTERRUPT, thread_, nullptr, nullptr) != 0) return;
        while (waitpid(thread_, nullptr, __WALL) < 0 && errno == EINTR) continue;
        is_stopped_ = true;
    }
    ~StoppedThread() { let_go(); }
    StoppedThread(const StoppedThread&) = delete;
    StoppedThread& operator=(const StoppedThread&) = delete;

    bool is_stopped() const { return is_stopped_; }
    void let_go() {
        if (is_stopped_) ptrace(PTRACE_DETACH, thread_, nullptr, nullptr);
        is_stopped_ = false;
    }

private:
    pid_t thread_;
    bool is_stopped_ = false;
};

}  // namespace psicarve::two_process
