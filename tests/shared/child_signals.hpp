// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>
#include <sys/prctl.h>

namespace psicarve::test {

/// Signals that the process that runs the tests may ignore (nohup, a job behind an &), and so would every
/// process that a test starts.
inline constexpr int kSignalsToTake[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};

/// In a child that was forked: signals do what they do to any program, and it does not outlive the test.
inline void be_a_usual_child() noexcept {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int number : kSignalsToTake) ::signal(number, SIG_DFL);
}

}  // namespace psicarve::test
