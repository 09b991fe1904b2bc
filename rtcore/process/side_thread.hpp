// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <thread>

#include "shared/computer/event.hpp"

namespace psicarve::rtcore {

/// Gives the calling thread only the processor time that no other thread wants: for threads that nothing
/// waits for.
void lower_own_priority() noexcept;

/// Runs tasks that may take long, or never end, in a thread of its own: writing to a disk, a terminal or a
/// pipe, looking through a large job. A thread that hands over a task never waits, not even for a mutex: a
/// low-priority thread that is preempted while it holds one keeps it for as long as others are busy. Not for
/// the tick.
class SideThread {
public:
    enum class Priority : std::uint8_t { low, ordinary };
    explicit SideThread(Priority priority = Priority::low, std::size_t most_tasks = 256);
    /// Waits until all is done, but only for a limited time: a thread that hangs is left to the end of the
    /// process.
    ~SideThread();
    SideThread(const SideThread&) = delete;
    SideThread& operator=(const SideThread&) = delete;

    /// Tasks run in their order; one that throws is reported, and the next one runs. A task owns or shares
    /// what it uses: it may outlive this object. False: too many tasks wait already, and this one is dropped.
    bool do_later(std::function<void()> task);

private:
    struct Task {
        std::function<void()> work;
        Task* next = nullptr;
    };
    struct Shared {
        ~Shared();
        std::atomic<Task*> newest{nullptr};  ///< a stack: each task points to the one before it
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
