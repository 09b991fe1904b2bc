// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/end_request.hpp"

#include <signal.h>

#include <atomic>

namespace psicarve::supervisor {
namespace {

// Signal handlers reach nothing else.
std::atomic<int> signals_received{0};

void count_signal(int /*signal_number*/) {
    signals_received.fetch_add(1);
}

}  // namespace

EndRequest::EndRequest() {
    struct sigaction action {};
    action.sa_handler = count_signal;
    sigemptyset(&action.sa_mask);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaction(number, &action, nullptr);
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);  // a file at its size limit is a full disk, and no reason to die in motion
}

EndRequest::Progress EndRequest::poll(Supervisor& supervisor) {
    const int signals = signals_received.load();
    if (signals != signals_seen_) {
        if (signals_seen_ == 0) supervisor.request_stop();
        if (signals > 1) supervisor.request_emergency_stop();
        signals_seen_ = signals;
        return Progress::told_tick;
    }
    const MachineState state = supervisor.sample().state;
    const bool is_quiet =
        state == MachineState::off || state == MachineState::ready || state == MachineState::alarm;
    return signals > 0 && is_quiet ? Progress::may_end : Progress::none;
}

}  // namespace psicarve::supervisor
