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

/// Something that may never end, as a look at a disk that hangs: a thread does it that nobody ever waits for
/// longer than he wants, not even this object's or the program's end. One at a time. One owner's thread.
template <typename Outcome>
class LooseWork {
public:
    /// `work` owns what it uses: it may outlive everything. Not while another is under way.
    void begin(std::function<Outcome()> work) {
        auto promise = std::make_shared<std::promise<Outcome>>();
        outcome_ = promise->get_future();
        // Signals are the program's.
        sigset_t all{};
        sigset_t before{};
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, &before);
        std::thread{[promise, work = std::move(work)] { promise->set_value(work()); }}.detach();
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
    }
    bool is_under_way() const noexcept { return outcome_.valid(); }
    /// What came of it, once; nothing: it goes on.
    std::optional<Outcome> take(std::chrono::milliseconds patience = std::chrono::milliseconds{0}) {
        if (!outcome_.valid() || outcome_.wait_for(patience) != std::future_status::ready)
            return std::nullopt;
        return outcome_.get();
    }

private:
    std::future<Outcome> outcome_;
};

}  // namespace psicarve::machine
