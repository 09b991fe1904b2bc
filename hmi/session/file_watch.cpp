// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/file_watch.hpp"

namespace psicarve::session {
namespace {

constexpr std::chrono::seconds kPause{1};

}  // namespace

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const std::string& path) {
    std::error_code unknown;
    Stamp stamp{std::filesystem::last_write_time(path, unknown), 0};
    if (unknown) return std::nullopt;
    stamp.bytes = std::filesystem::file_size(path, unknown);
    if (unknown) return std::nullopt;
    return stamp;
}

void FileWatch::watch(const std::string& path, const std::optional<Stamp>& opened) {
    path_ = path;
    opened_ = opened;
    has_changed_ = false;
    is_change_taken_ = false;
}

void FileWatch::poll(Clock::time_point now) {
    queue_.deliver();
    if (!opened_ || has_changed_ || now < next_look_ || !queue_.is_idle()) return;
    next_look_ = now + kPause;
    queue_.post([this, path = path_]() -> BackgroundQueue::Finish {
        return [this, path, seen = stamp_of(path)] {
            if (path == path_ && seen && opened_) has_changed_ = *seen != *opened_;
        };
    });
}

}  // namespace psicarve::session
