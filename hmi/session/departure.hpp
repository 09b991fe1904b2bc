// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "hmi/session/pending_saves.hpp"

namespace psicarve::session {

/// How a program whose window has closed ends when a disk does not answer: it waits for a save as long as the
/// disk makes progress, and for nothing else.
class Departure {
public:
    using Clock = std::chrono::steady_clock;
    enum class Step : std::uint8_t {
        wait,
        tell,     ///< the user may wonder why the program still runs; once
        leave,    ///< nothing is being saved: no need to wait for what hangs
        give_up,  ///< the save will never end
    };

    static constexpr std::chrono::seconds kTell{2};
    static constexpr std::chrono::seconds kLeave{3};
    static constexpr std::chrono::seconds kGiveUp{30};

    explicit Departure(Clock::time_point now) : begin_(now), last_change_(now) {}
    Step look(Clock::time_point now, const std::vector<SaveUnderWay>& saves);

private:
    Clock::time_point begin_;
    Clock::time_point last_change_;
    std::vector<SaveUnderWay> before_;
    bool has_told_ = false;
};

/// Runs four times a second until the program ends: reports on stderr what it waits for, and ends the process
/// when a Departure says so.
class DepartureWatch {
public:
    /// `leave` ends the process: with the program's own exit code, or, if `is_lost`, with that of an error.
    DepartureWatch(PendingSaves saves, std::function<void(bool is_lost)> leave);
    ~DepartureWatch();
    DepartureWatch(const DepartureWatch&) = delete;
    DepartureWatch& operator=(const DepartureWatch&) = delete;

private:
    void watch();

    PendingSaves saves_;
    std::function<void(bool)> leave_;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool ends_ = false;
    std::thread thread_;
};

/// "a.job, b.snap"
std::string paths_of(const std::vector<SaveUnderWay>& saves);

}  // namespace psicarve::session
