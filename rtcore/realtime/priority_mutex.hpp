// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pthread.h>

namespace psicarve::rtcore {

/// A mutex of this process alone with priority inheritance: its holder runs at the priority of the thread
/// that waits for it. For std::scoped_lock. RT: yes, where a lock is allowed at all (schedule two-timer).
class PriorityMutex {
public:
    PriorityMutex() noexcept {
        pthread_mutexattr_t attributes;
        pthread_mutexattr_init(&attributes);
        inherits_ = pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT) == 0;
        pthread_mutex_init(&mutex_, &attributes);
        pthread_mutexattr_destroy(&attributes);
    }
    ~PriorityMutex() { pthread_mutex_destroy(&mutex_); }
    PriorityMutex(const PriorityMutex&) = delete;
    PriorityMutex& operator=(const PriorityMutex&) = delete;

    void lock() noexcept { pthread_mutex_lock(&mutex_); }
    void unlock() noexcept { pthread_mutex_unlock(&mutex_); }
    bool inherits_priority() const noexcept { return inherits_; }

private:
    pthread_mutex_t mutex_;
    bool inherits_ = false;
};

}  // namespace psicarve::rtcore
