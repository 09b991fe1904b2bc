// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace psicarve::machine {

/// Runs a task that may never end, such as a look at a disk that hangs, in a thread that the caller waits for
/// only as long as it wants; neither the destructor nor the program's end waits. One task at a time. One
/// owner's thread.
template <typename Outcome>
class LooseWork {
public:
    /// `work` owns what it uses: it may outlive everything. Requires that no other task runs.
    void begin(std::function<Outcome()> work) {
        auto promise = std::make_shared<std::promise<Outcome>>();
        outcome_ = promise->get_future();
        // Signals belong to the program's other threads.
        sigset_t all{};
        sigset_t before{};
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, &before);
        std::thread{[promise, work = std::move(work)] { promise->set_value(work()); }}.detach();
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
    }
    bool is_under_way() const noexcept { return outcome_.valid(); }
    /// The task's result, once; nothing: it still runs.
    std::optional<Outcome> take(std::chrono::milliseconds patience = std::chrono::milliseconds{0}) {
        if (!outcome_.valid() || outcome_.wait_for(patience) != std::future_status::ready)
            return std::nullopt;
        return outcome_.get();
    }

private:
    std::future<Outcome> outcome_;
};

}  // namespace psicarve::machine
