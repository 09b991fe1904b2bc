// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <thread>

#include "shared/computer/event.hpp"

namespace psicarve::rtcore {

/// So much of the computer as nobody else wants: for threads that nothing waits for.
void lower_own_priority() noexcept;

/// Does what may take long, or never end, in a thread of its own: writing to a disk, a terminal or a pipe,
/// looking through a large job. Whoever gives it something to do never waits for it, not even for a mutex:
/// a thread of low priority that is interrupted while it holds one keeps it for as long as others are busy.
/// Not for the tick.
class SideThread {
public:
    enum class Priority : std::uint8_t { low, ordinary };
    explicit SideThread(Priority priority = Priority::low, std::size_t most_tasks = 256);
    /// Waits until all is done, but no longer than so: a thread that hangs is left to the end of the process.
    ~SideThread();
    SideThread(const SideThread&) = delete;
    SideThread& operator=(const SideThread&) = delete;

    /// Each task after the last; one that throws is said, and ends nothing. It owns what it uses, or shares
    /// it: it may outlive this object. False: too much waits already; it will not be done.
    bool do_later(std::function<void()> task);

private:
    struct Task {
        std::function<void()> work;
        Task* next = nullptr;
    };
    struct Shared {
        ~Shared();
        std::atomic<Task*> newest{nullptr};  ///< a stack: each knows the one before it
        std::atomic<std::size_t> waiting{0};
        std::atomic<bool> must_end{false};
        std::atomic<bool> has_ended{false};
        EventWord given;
        EventWord ended;
    };
    static void do_all(Shared& shared);
    static void run(Shared& shared, Priority priority);

    std::size_t most_tasks_;
    std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
    std::thread thread_;
};

}  // namespace psicarve::rtcore
