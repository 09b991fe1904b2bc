// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/process/side_thread.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <exception>
#include <utility>

#include "rtcore/process/handler_stack.hpp"
#include "rtcore/process/words.hpp"

namespace psicarve::rtcore {
namespace {

constexpr std::chrono::seconds kPatience{2};
constexpr std::chrono::hours kUntilSomethingHappens{24};

/// Runs a task whatever a disk or a lack of memory does to it: the machine is at work.
void do_one(const std::function<void()>& work) noexcept {
    try {
        work();
    } catch (const std::exception& problem) {
        try_to_say(problem.what());
    } catch (...) {
        try_to_say("a task beside the tick was not done");
    }
}

}  // namespace

void lower_own_priority() noexcept {
    constexpr int kLowPriority = 10;  // nice
    // A refusal does not matter: it only lowers the priority. On Linux each thread has a niceness of its own.
    static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLowPriority));
}

SideThread::SideThread(Priority priority, std::size_t most_tasks)
    : most_tasks_(most_tasks), thread_([shared = shared_, priority] { run(*shared, priority); }) {}

SideThread::Shared::~Shared() {
    for (Task* task = newest.load(); task != nullptr;) delete std::exchange(task, task->next);
}

SideThread::~SideThread() {
    const std::uint32_t seen = event_count(shared_->ended);
    shared_->must_end.store(true);
    event_signal(shared_->given);
    if (!shared_->has_ended.load()) event_wait_past(shared_->ended, seen, kPatience);
    if (shared_->has_ended.load()) {
        thread_.join();
    } else {
        thread_.detach();
    }
}

bool SideThread::do_later(std::function<void()> work) {
    if (shared_->waiting.fetch_add(1) >= most_tasks_) {
        shared_->waiting.fetch_sub(1);
        return false;
    }
    Task* const task = new Task{std::move(work), shared_->newest.load()};
    while (!shared_->newest.compare_exchange_weak(task->next, task)) {
    }
    event_signal(shared_->given);
    return true;
}

void SideThread::do_all(Shared& shared) {
    Task* oldest = nullptr;
    for (Task* task = shared.newest.exchange(nullptr); task != nullptr;) {
        Task* const before = task->next;
        task->next = oldest;
        oldest = std::exchange(task, before);
    }
    while (oldest != nullptr) {
        const std::unique_ptr<Task> task{std::exchange(oldest, oldest->next)};
        shared.waiting.fetch_sub(1);
        do_one(task->work);
    }
}

void SideThread::run(Shared& shared, Priority priority) {
    const HandlerStack handler_stack;
    if (priority == Priority::low) lower_own_priority();
    for (;;) {
        const std::uint32_t seen = event_count(shared.given);
        // Tasks that were given before the end was asked for still run.
        const bool must_end = shared.must_end.load();
        do_all(shared);
        if (must_end) break;
        event_wait_past(shared.given, seen, kUntilSomethingHappens);
    }
    shared.has_ended.store(true);
    event_signal(shared.ended);
}

}  // namespace psicarve::rtcore
