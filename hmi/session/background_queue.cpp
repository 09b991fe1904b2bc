// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/background_queue.hpp"

#include <sys/resource.h>

#include <utility>

namespace psicarve::session {
namespace {

constexpr int kGivesWay = 10;

}  // namespace

BackgroundQueue::BackgroundQueue(Haste haste) : thread_([this, haste] { work(haste); }) {}

BackgroundQueue::~BackgroundQueue() {
    {
        const std::lock_guard lock{mutex_};
        ends_ = true;
        tasks_.clear();
    }
    wake_.notify_all();
    thread_.join();
}

void BackgroundQueue::post(Task task) {
    {
        const std::lock_guard lock{mutex_};
        tasks_.push_back(std::move(task));
    }
    wake_.notify_all();
}

void BackgroundQueue::drop_waiting() {
    const std::lock_guard lock{mutex_};
    tasks_.clear();
}

void BackgroundQueue::finish() {
    std::unique_lock lock{mutex_};
    wake_.wait(lock, [this] { return tasks_.empty() && !is_working_; });
}

bool BackgroundQueue::is_idle() const {
    const std::lock_guard lock{mutex_};
    return tasks_.empty() && !is_working_ && finished_.empty();
}

void BackgroundQueue::deliver() {
    std::vector<Finish> ready;
    {
        const std::lock_guard lock{mutex_};
        ready.swap(finished_);
    }
    for (const Finish& finish : ready) {
        if (finish) finish();
    }
}

void BackgroundQueue::work(Haste haste) {
    // On Linux a thread has a priority of its own, which threads that it starts inherit.
    if (haste == Haste::background) ::setpriority(PRIO_PROCESS, 0, kGivesWay);
    std::unique_lock lock{mutex_};
    while (true) {
        wake_.wait(lock, [this] { return ends_ || !tasks_.empty(); });
        if (ends_) return;
        Task task = std::move(tasks_.front());
        tasks_.pop_front();
        is_working_ = true;
        lock.unlock();
        Finish finish = task();
        task = nullptr;  // releases what the task holds here, not under the lock
        lock.lock();
        is_working_ = false;
        finished_.push_back(std::move(finish));
        wake_.notify_all();
    }
}

}  // namespace psicarve::session
