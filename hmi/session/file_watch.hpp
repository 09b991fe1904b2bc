// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "hmi/session/background_queue.hpp"

namespace psicarve::session {

/// Watches whether a file was written since it was opened: looks once a second, on a thread of its own. All
/// calls come from one thread, the owner's.
class FileWatch {
public:
    using Clock = std::chrono::steady_clock;

    /// Distinguishes states of a file.
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t bytes = 0;
        bool operator==(const Stamp&) const = default;
    };
    /// Nothing when the file does not exist. Any thread.
    static std::optional<Stamp> stamp_of(const std::string& path);

    /// Watches this file from now on, which was opened in that state; without a state it watches nothing.
    void watch(const std::string& path, const std::optional<Stamp>& opened);
    void poll(Clock::time_point now);
    /// The state in which it was opened.
    const std::optional<Stamp>& opened() const noexcept { return opened_; }
    /// The file that it watches; empty: none.
    const std::string& path() const noexcept { return path_; }
    /// A missing file has not changed: many programs write another and move it here.
    bool has_changed() const noexcept { return has_changed_; }
    /// The same, but true only once after each watch(): for a report.
    bool take_change() noexcept { return has_changed_ && !std::exchange(is_change_taken_, true); }

private:
    std::string path_;
    std::optional<Stamp> opened_;
    bool has_changed_ = false;
    bool is_change_taken_ = false;
    Clock::time_point next_look_{};
    BackgroundQueue queue_;  // last: its thread uses the others
};

}  // namespace psicarve::session
