// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/promptness.hpp"

#include <pthread.h>
#include <sched.h>

namespace psicarve::rtcore {
namespace {

bool set_policy(int policy, int priority) noexcept {
    const sched_param parameters{.sched_priority = priority};
    return pthread_setschedparam(pthread_self(), policy, &parameters) == 0;
}

bool is_ordinary() noexcept {
    int policy = 0;
    sched_param parameters{};
    return pthread_getschedparam(pthread_self(), &policy, &parameters) == 0 && policy == SCHED_OTHER;
}

}  // namespace

void Promptness::raise() noexcept {
    constexpr int kLeastPriority = 1;
    if (!is_possible_ || is_raised_) return;
    is_raised_ = is_ordinary() && set_policy(SCHED_FIFO, kLeastPriority);
    is_possible_ = is_raised_;
}

void Promptness::lower() noexcept {
    if (is_raised_) is_raised_ = !set_policy(SCHED_OTHER, 0);
}

}  // namespace psicarve::rtcore
