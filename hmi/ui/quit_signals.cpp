// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/quit_signals.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <utility>

namespace psicarve::ui {
namespace {

std::atomic<int> signal_pipe{-1};  // a handler has nothing else to go by

/// May interrupt anything: one write is all that is allowed here.
void tell_the_loop(int) {
    const int before = errno;
    const char any = 0;
    [[maybe_unused]] const auto written = ::write(signal_pipe.load(), &any, 1);
    errno = before;
}

}  // namespace

QuitSignals::QuitSignals(std::function<void()> quit) {
    if (::pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;
    signal_pipe.store(pipe_[1]);
    ear_ = std::make_unique<QSocketNotifier>(pipe_[0], QSocketNotifier::Read);
    QObject::connect(ear_.get(), &QSocketNotifier::activated, ear_.get(), [this, quit = std::move(quit)] {
        ear_->setEnabled(false);
        quit();
    });
    struct sigaction told {};
    told.sa_handler = tell_the_loop;
    told.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    sigemptyset(&told.sa_mask);
    for (std::size_t i = 0; i < kNumbers.size(); ++i) {
        ::sigaction(kNumbers[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN) ::sigaction(kNumbers[i], &told, nullptr);
    }
}

QuitSignals::~QuitSignals() {
    if (!ear_) return;
    for (std::size_t i = 0; i < kNumbers.size(); ++i) ::sigaction(kNumbers[i], &before_[i], nullptr);
    ear_.reset();
    signal_pipe.store(-1);
    for (const int end : pipe_) ::close(end);
}

}  // namespace psicarve::ui
