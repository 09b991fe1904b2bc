// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/guard/dying.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>

namespace psicarve::guard {
namespace {

/// The text behind "NAME:" and blanks at the begin of a line; empty: there is no such line.
std::string_view value_of(std::string_view status, std::string_view name) noexcept {
    for (std::size_t at = 0; at < status.size();) {
        const std::size_t end = std::min(status.find('\n', at), status.size());
        const std::string_view line = status.substr(at, end - at);
        if (line.substr(0, name.size()) == name) {
            const std::size_t value = line.find_first_not_of(" \t", name.size());
            return value == std::string_view::npos ? std::string_view{} : line.substr(value);
        }
        at = end + 1;
    }
    return {};
}

bool has_kill_in(std::string_view mask_text) noexcept {
    std::uint64_t mask = 0;
    std::from_chars(mask_text.data(), mask_text.data() + mask_text.size(), mask, 16);
    return (mask >> (SIGKILL - 1) & 1U) != 0;
}

}  // namespace

bool says_dying(std::string_view status) noexcept {
    const std::string_view state = value_of(status, "State:");
    if (!state.empty() && (state.front() == 'Z' || state.front() == 'X')) return true;
    return has_kill_in(value_of(status, "SigPnd:")) || has_kill_in(value_of(status, "ShdPnd:"));
}

DyingWatch::DyingWatch(pid_t pid) noexcept {
    std::array<char, 64> path{};
    std::snprintf(path.data(), path.size(), "/proc/%d/status", static_cast<int>(pid));
    status_ = open(path.data(), O_RDONLY | O_CLOEXEC);
}

DyingWatch::~DyingWatch() {
    if (status_ >= 0) close(status_);
}

bool DyingWatch::is_dying() const noexcept {
    std::array<char, 4096> text{};
    const ssize_t length = pread(status_, text.data(), text.size(), 0);
    return length > 0 && says_dying({text.data(), static_cast<std::size_t>(length)});
}

}  // namespace psicarve::guard
