// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/end_request.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>

namespace psicarve::supervisor {
namespace {

// Signal handlers reach nothing else.
std::atomic<int> orders_of_parent{0};
std::atomic<int> orders_of_others{0};

void count_order(int /*signal_number*/, siginfo_t* info, void* /*context*/) {
    const bool is_of_parent = info->si_code <= 0 && info->si_pid == getppid();
    (is_of_parent ? orders_of_parent : orders_of_others).fetch_add(1);
}

}  // namespace

EndRequest::EndRequest() {
    struct sigaction action {};
    action.sa_sigaction = count_order;
    action.sa_flags = SA_SIGINFO;
    sigemptyset(&action.sa_mask);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaction(number, &action, nullptr);
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);  // a file at its size limit is a full disk, and no reason to die in motion
}

// One order may come by two ways: by itself, and handed on by the guard, our parent.
int EndRequest::orders() noexcept {
    return std::max(orders_of_parent.load(), orders_of_others.load());
}

EndRequest::Progress EndRequest::poll(Supervisor& supervisor) {
    const int orders = EndRequest::orders();
    if (orders != orders_seen_) {
        if (orders_seen_ == 0) supervisor.request_stop();
        if (orders > 1) supervisor.request_emergency_stop();
        orders_seen_ = orders;
        return Progress::told_tick;
    }
    const MachineState state = supervisor.sample().state;
    const bool is_quiet =
        state == MachineState::off || state == MachineState::ready || state == MachineState::alarm;
    return orders > 0 && is_quiet ? Progress::may_end : Progress::none;
}

}  // namespace psicarve::supervisor
