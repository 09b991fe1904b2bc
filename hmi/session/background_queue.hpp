// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace psicarve::session {

/// A thread that runs tasks one after the other for an owner that must never wait. The owner's next deliver()
/// runs, on the owner's thread, what a task returns.
class BackgroundQueue {
public:
    using Finish = std::function<void()>;
    using Task = std::function<Finish()>;

    /// Background: long work that gives way to the window and to a core on the same computer.
    enum class Haste : std::uint8_t { prompt, background };

    explicit BackgroundQueue(Haste haste = Haste::prompt);
    /// Drops waiting tasks, and undelivered results; waits for the task that runs.
    ~BackgroundQueue();
    BackgroundQueue(const BackgroundQueue&) = delete;
    BackgroundQueue& operator=(const BackgroundQueue&) = delete;

    void post(Task task);
    void drop_waiting();
    /// Waits until all tasks have run.
    void finish();
    /// No task waits, runs, or is undelivered.
    bool is_idle() const;
    void deliver();

private:
    void work(Haste haste);

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Task> tasks_;
    std::vector<Finish> finished_;
    bool is_working_ = false;
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace psicarve::session
