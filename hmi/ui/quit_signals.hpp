// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSocketNotifier>

#include <array>
#include <csignal>
#include <functional>
#include <memory>

namespace psicarve::ui {

/// SIGTERM, SIGINT and SIGHUP as a call in the event loop. One object at a time. A second signal of a kind
/// ends the program as without this; one that is ignored (nohup) stays so.
class QuitSignals {
public:
    explicit QuitSignals(std::function<void()> quit);
    ~QuitSignals();
    QuitSignals(const QuitSignals&) = delete;
    QuitSignals& operator=(const QuitSignals&) = delete;

private:
    static constexpr std::array<int, 3> kNumbers{SIGTERM, SIGINT, SIGHUP};

    std::array<struct sigaction, kNumbers.size()> before_{};
    std::array<int, 2> pipe_{-1, -1};
    std::unique_ptr<QSocketNotifier> ear_;
};

}  // namespace psicarve::ui
