// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rtcore/tick_counters.hpp"

#include <dlfcn.h>
#include <linux/ppdev.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <ctime>

#include "tests/system_calls/call_filter.hpp"

namespace psicarve::tick_counters {
namespace {

thread_local bool is_counting = false;
thread_local Counts counted;
thread_local rusage usage_before{};

void note(std::uint64_t Counts::*counter) noexcept {
    if (is_counting) ++(counted.*counter);
}

void note_call(long number) noexcept {
    if (!is_counting) return;
    if (number == SYS_clock_nanosleep) {
        ++counted.sleeps;
        return;
    }
    ++counted.other_system_calls;
    counted.last_other_call = number;
}

std::uint64_t page_faults_of(const rusage& usage) noexcept {
    return static_cast<std::uint64_t>(usage.ru_minflt + usage.ru_majflt);
}

/// What comes after ours, of this name.
template <typename Function>
Function* next_of(const char* name) noexcept {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

bool watch_this_thread() noexcept {
    return system_calls::watch_this_thread(note_call);
}

void begin_counting() noexcept {
    counted = Counts{};
    getrusage(RUSAGE_THREAD, &usage_before);
    is_counting = true;
}

void end_counting(Counts& counts) noexcept {
    is_counting = false;
    rusage now{};
    getrusage(RUSAGE_THREAD, &now);
    counts.page_faults += page_faults_of(now) - page_faults_of(usage_before);
    counts.switches += static_cast<std::uint64_t>(now.ru_nvcsw - usage_before.ru_nvcsw);
    counts.allocations += counted.allocations;
    counts.locks += counted.locks;
    counts.waits += counted.waits;
    counts.port_accesses += counted.port_accesses;
    counts.sleeps += counted.sleeps;
    counts.other_system_calls += counted.other_system_calls;
    if (counted.last_other_call >= 0) counts.last_other_call = counted.last_other_call;
}

}  // namespace psicarve::tick_counters

namespace {

using psicarve::tick_counters::Counts;
using psicarve::tick_counters::kPortDescriptor;
using psicarve::tick_counters::next_of;
using psicarve::tick_counters::note;

/// Conditions exist twice in the C library; the older ones are other structs.
template <typename Function>
Function* condition_next_of(const char* name) noexcept {
    return reinterpret_cast<Function*>(dlvsym(RTLD_NEXT, name, "GLIBC_2.3.2"));
}

/// A function of the C library that tries a lock: counted, then done.
template <typename Function, typename... Arguments>
int try_by(Function* next, Arguments... arguments) {
    note(&Counts::locks);
    return next(arguments...);
}

/// One that takes it, however long that takes.
template <typename Function, typename... Arguments>
int lock_by(Function* next, Arguments... arguments) {
    note(&Counts::waits);
    return try_by(next, arguments...);
}

}  // namespace

extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* memory, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
void __libc_free(void* memory);

void* malloc(std::size_t bytes) {
    note(&Counts::allocations);
    return __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
    note(&Counts::allocations);
    return __libc_calloc(count, bytes);
}
void* realloc(void* memory, std::size_t bytes) {
    note(&Counts::allocations);
    return __libc_realloc(memory, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
    note(&Counts::allocations);
    return __libc_memalign(alignment, bytes);
}
void* memalign(std::size_t alignment, std::size_t bytes) {
    note(&Counts::allocations);
    return __libc_memalign(alignment, bytes);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) {
    note(&Counts::allocations);
    *memory = __libc_memalign(alignment, bytes);
    return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) {
    note(&Counts::allocations);
    __libc_free(memory);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) {
    static auto* const next = next_of<int(pthread_mutex_t*)>("pthread_mutex_lock");
    return lock_by(next, mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) {
    static auto* const next = next_of<int(pthread_mutex_t*)>("pthread_mutex_trylock");
    return try_by(next, mutex);
}
int pthread_mutex_timedlock(pthread_mutex_t* mutex, const timespec* limit) {
    static auto* const next = next_of<int(pthread_mutex_t*, const timespec*)>("pthread_mutex_timedlock");
    return lock_by(next, mutex, limit);
}
int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock, const timespec* limit) {
    static auto* const next =
        next_of<int(pthread_mutex_t*, clockid_t, const timespec*)>("pthread_mutex_clocklock");
    return lock_by(next, mutex, clock, limit);
}
int pthread_spin_lock(pthread_spinlock_t* lock) {
    static auto* const next = next_of<int(pthread_spinlock_t*)>("pthread_spin_lock");
    return lock_by(next, lock);
}
int pthread_spin_trylock(pthread_spinlock_t* lock) {
    static auto* const next = next_of<int(pthread_spinlock_t*)>("pthread_spin_trylock");
    return try_by(next, lock);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) {
    static auto* const next = next_of<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
    return lock_by(next, lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) {
    static auto* const next = next_of<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
    return lock_by(next, lock);
}
int pthread_rwlock_tryrdlock(pthread_rwlock_t* lock) {
    static auto* const next = next_of<int(pthread_rwlock_t*)>("pthread_rwlock_tryrdlock");
    return try_by(next, lock);
}
int pthread_rwlock_trywrlock(pthread_rwlock_t* lock) {
    static auto* const next = next_of<int(pthread_rwlock_t*)>("pthread_rwlock_trywrlock");
    return try_by(next, lock);
}
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
    static auto* const next = condition_next_of<int(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait");
    return lock_by(next, condition, mutex);
}
int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* limit) {
    static auto* const next =
        condition_next_of<int(pthread_cond_t*, pthread_mutex_t*, const timespec*)>("pthread_cond_timedwait");
    return lock_by(next, condition, mutex, limit);
}
int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                           const timespec* limit) {
    static auto* const next =
        next_of<int(pthread_cond_t*, pthread_mutex_t*, clockid_t, const timespec*)>("pthread_cond_clockwait");
    return lock_by(next, condition, mutex, clock, limit);
}
int sem_wait(sem_t* semaphore) {
    static auto* const next = next_of<int(sem_t*)>("sem_wait");
    return lock_by(next, semaphore);
}
int sem_trywait(sem_t* semaphore) {
    static auto* const next = next_of<int(sem_t*)>("sem_trywait");
    return try_by(next, semaphore);
}
int sem_timedwait(sem_t* semaphore, const timespec* limit) {
    static auto* const next = next_of<int(sem_t*, const timespec*)>("sem_timedwait");
    return lock_by(next, semaphore, limit);
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
    static auto* const next = next_of<int(int, unsigned long, void*)>("ioctl");
    va_list list;
    va_start(list, request);
    void* const argument = va_arg(list, void*);
    va_end(list);
    if (descriptor != kPortDescriptor) return next(descriptor, request, argument);
    note(&Counts::port_accesses);
    if (request == PPRSTATUS) *static_cast<std::uint8_t*>(argument) = 0x80;
    return 0;
}
}
