// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

#include "shared/base/result.hpp"
#include "shared/segment/layout.hpp"

namespace psicarve {

/// The interprocess mutex of publishers and snapshot takers: pthread, PROCESS_SHARED + ROBUST + PRIO_INHERIT
/// + ERRORCHECK, in shared memory. `boost::interprocess::scoped_lock<RobustMutex>` accepts it.
///
/// Owner death: the next locker gets the lock, marks it consistent and sees `recovered()` true: the work of
/// the dead owner is half done. All that the mutex guards is written so that this is harmless: first a slot
/// that is not in use, and only then the publication. A locker waits for a stopped owner until the time
/// limit. The core never locks it. Not for the tick.
class RobustMutex {
public:
    /// Once, by the creator of the segment, before `ready`.
    static Result<void> initialise(MutexStorage& storage);

    /// The process that alone serves the segment calls this as it begins: it makes the mutex anew where its
    /// bytes are no mutex. No process can hold such a one, and a process that tries to lock it meanwhile is
    /// refused. A valid mutex stays as it is, held or not.
    static Result<void> make_whole(MutexStorage& storage);

    explicit RobustMutex(MutexStorage& storage) noexcept : storage_(&storage) {}

    void lock();  ///< waits at most kLockLimit; throws boost::interprocess::lock_exception then
    bool try_lock();
    /// Result: timed_out names the holder's pid; bad_input when the bytes are no usable mutex.
    Result<void> lock_within(std::chrono::milliseconds limit);
    void unlock();
    bool recovered() const noexcept { return recovered_; }
    std::uint32_t holder_pid() const noexcept { return storage_->holder_pid.load(); }

    static constexpr std::chrono::milliseconds kLockLimit{5000};

private:
    MutexStorage* storage_;
    bool recovered_ = false;
};

}  // namespace psicarve
