// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "hmi/session/work_lane.hpp"

namespace psicarve::session {

/// Whether a file was written since it was opened. It is looked at once a second, on a thread of its own. One
/// thread, the owner's.
class FileWatch {
public:
    using Clock = std::chrono::steady_clock;

    /// What tells one state of a file from another.
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t bytes = 0;
        bool operator==(const Stamp&) const = default;
    };
    /// Nothing when it is not there. Any thread.
    static std::optional<Stamp> stamp_of(const std::string& path);

    /// From now on this file, which was opened in that state; without one nothing is watched.
    void watch(const std::string& path, const std::optional<Stamp>& opened);
    void poll(Clock::time_point now);
    /// In what state it was opened.
    const std::optional<Stamp>& opened() const noexcept { return opened_; }
    /// A file that is gone has not changed: many programs write another and move it here.
    bool has_changed() const noexcept { return has_changed_; }

private:
    std::string path_;
    std::optional<Stamp> opened_;
    bool has_changed_ = false;
    Clock::time_point next_look_{};
    WorkLane lane_;  // last: its thread uses the others
};

}  // namespace psicarve::session
