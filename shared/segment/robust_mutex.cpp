// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/robust_mutex.hpp"

#include <linux/futex.h>
#include <signal.h>
#include <sys/types.h>
#include <time.h>

#include <boost/interprocess/exceptions.hpp>
#include <cerrno>
#include <string>
#include <system_error>

#include "shared/computer/process_identity.hpp"

namespace psicarve {
namespace {

/// How often a mutex is tried where the kernel offers no priority-inheriting wait on the monotonic clock.
constexpr std::chrono::microseconds kPollInterval{500};

// GCC 12's ThreadSanitizer does not see pthread_mutex_clocklock and would take every unlock for a wrong one.
#if defined(__SANITIZE_THREAD__)
constexpr bool kDoesWaitInKernel = false;
#else
constexpr bool kDoesWaitInKernel = true;
#endif

std::string text_of(int error_number) {
    return std::generic_category().message(error_number);
}

int initialise_native(pthread_mutex_t& mutex) noexcept {
    pthread_mutexattr_t attributes;
    if (const int failed = ::pthread_mutexattr_init(&attributes); failed != 0) return failed;
    int failed = ::pthread_mutexattr_setpshared(&attributes, PTHREAD_PROCESS_SHARED);
    if (failed == 0) failed = ::pthread_mutexattr_setrobust(&attributes, PTHREAD_MUTEX_ROBUST);
    if (failed == 0) failed = ::pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT);
    if (failed == 0) failed = ::pthread_mutexattr_settype(&attributes, PTHREAD_MUTEX_ERRORCHECK);
    if (failed == 0) failed = ::pthread_mutex_init(&mutex, &attributes);
    ::pthread_mutexattr_destroy(&attributes);
    return failed;
}

/// The kind that glibc stores in a mutex with our four attributes.
int kind_of_ours() noexcept {
    static const int kind = [] {
        pthread_mutex_t model;
        return initialise_native(model) == 0 ? model.__data.__kind : -1;
    }();
    return kind;
}

/// glibc asserts or hangs on bytes that are no mutex, so this checks them before glibc gets them.
bool is_one_of_ours(const pthread_mutex_t& mutex) noexcept {
    if (__atomic_load_n(&mutex.__data.__kind, __ATOMIC_RELAXED) != kind_of_ours()) return false;
    // The kernel removes a dying owner's number from the lock word before it forgets the thread. A number
    // that no thread has is therefore no dead owner but garbage, on which glibc would abort.
    const int word = __atomic_load_n(&mutex.__data.__lock, __ATOMIC_RELAXED);
    const pid_t owner = word & static_cast<int>(FUTEX_TID_MASK);
    if (owner == 0 || ::kill(owner, 0) == 0 || errno != ESRCH) return true;
    return __atomic_load_n(&mutex.__data.__lock, __ATOMIC_RELAXED) != word;
}

timespec monotonic_after(std::chrono::milliseconds limit) noexcept {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    const std::int64_t total_ns = now.tv_nsec + std::chrono::nanoseconds{limit}.count();
    now.tv_sec += static_cast<time_t>(total_ns / 1'000'000'000);
    now.tv_nsec = static_cast<long>(total_ns % 1'000'000'000);
    return now;
}

int lock_by_polling(pthread_mutex_t& mutex, std::chrono::milliseconds limit) noexcept {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    for (;;) {
        const int failed = ::pthread_mutex_trylock(&mutex);
        if (failed != EBUSY) return failed;
        if (std::chrono::steady_clock::now() >= deadline) return ETIMEDOUT;
        const timespec pause{.tv_sec = 0, .tv_nsec = std::chrono::nanoseconds{kPollInterval}.count()};
        ::clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, nullptr);
    }
}

int lock_native(pthread_mutex_t& mutex, std::chrono::milliseconds limit) noexcept {
    if (!kDoesWaitInKernel) return lock_by_polling(mutex, limit);
    const timespec deadline = monotonic_after(limit);
    const int failed = ::pthread_mutex_clocklock(&mutex, CLOCK_MONOTONIC, &deadline);
    // Kernels before 5.14 know no FUTEX_LOCK_PI2.
    return failed == EINVAL || failed == ENOSYS ? lock_by_polling(mutex, limit) : failed;
}

std::string describe_holder(std::uint32_t pid) {
    if (pid == 0) return "another process";
    return "process " + std::to_string(pid);
}

}  // namespace

Result<void> RobustMutex::initialise(MutexStorage& storage) {
    storage.holder_pid.store(0);
    if (const int failed = initialise_native(storage.native); failed != 0) {
        return Error{ErrorCode::bad_input, "cannot make a mutex between processes: " + text_of(failed)};
    }
    return {};
}

Result<void> RobustMutex::make_whole(MutexStorage& storage) {
    return is_one_of_ours(storage.native) ? Result<void>{} : initialise(storage);
}

Result<void> RobustMutex::lock_within(std::chrono::milliseconds limit) {
    if (!is_one_of_ours(storage_->native)) {
        return bad_input(
            "the segment's mutex is overwritten: end the core and start it again, which makes it anew");
    }
    const int failed = lock_native(storage_->native, limit);
    if (failed == ETIMEDOUT) {
        return Error{ErrorCode::timed_out, describe_holder(holder_pid()) +
                                               " holds the segment's mutex and did not let go within " +
                                               std::to_string(limit.count()) + " ms: continue or end it"};
    }
    if (failed != 0 && failed != EOWNERDEAD) {
        return bad_input("cannot lock the segment's mutex: " + text_of(failed));
    }
    recovered_ = failed == EOWNERDEAD;
    if (recovered_) ::pthread_mutex_consistent(&storage_->native);
    storage_->holder_pid.store(own_pid());
    return {};
}

void RobustMutex::lock() {
    if (!lock_within(kLockLimit)) throw boost::interprocess::lock_exception();
}

bool RobustMutex::try_lock() {
    if (!is_one_of_ours(storage_->native)) return false;
    const int failed = ::pthread_mutex_trylock(&storage_->native);
    if (failed != 0 && failed != EOWNERDEAD) return false;
    recovered_ = failed == EOWNERDEAD;
    if (recovered_) ::pthread_mutex_consistent(&storage_->native);
    storage_->holder_pid.store(own_pid());
    return true;
}

void RobustMutex::unlock() {
    storage_->holder_pid.store(0);
    ::pthread_mutex_unlock(&storage_->native);
}

}  // namespace psicarve
