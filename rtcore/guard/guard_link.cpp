// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/guard/guard_link.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace psicarve::guard {
namespace {

/// A hundred of the guard's looks.
constexpr std::chrono::seconds kLongestSilence{2};
/// The most that one pause between our looks counts: in it the guard may have stood still as well, as in a
/// suspended computer.
constexpr std::chrono::milliseconds kLongestStep{20};

bool is_closed(int pipe_end) noexcept {
    pollfd pipe{.fd = pipe_end, .events = POLLIN, .revents = 0};
    return poll(&pipe, 1, 0) > 0 && (pipe.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

}  // namespace

bool Silence::is_too_long(std::uint64_t count, Time now) noexcept {
    const auto step = std::min<std::chrono::nanoseconds>(now - asked_at_, kLongestStep);
    length_ = count == seen_ ? length_ + step : std::chrono::nanoseconds{0};
    seen_ = count;
    asked_at_ = now;
    return length_ > kLongestSilence;
}

GuardLink::GuardLink(int from_guard, int to_guard, GuardPage page) noexcept
    : from_guard_(from_guard), to_guard_(to_guard), page_(std::move(page)) {}

GuardLink::GuardLink(GuardLink&& other) noexcept
    : from_guard_(std::exchange(other.from_guard_, -1)),
      to_guard_(std::exchange(other.to_guard_, -1)),
      page_(std::move(other.page_)),
      acts_seen_(other.acts_seen_) {}

GuardLink::~GuardLink() {
    if (from_guard_ >= 0) close(from_guard_);
    if (to_guard_ >= 0) close(to_guard_);
}

bool GuardLink::guard_has_acted() noexcept {
    const std::uint32_t acts = page_.acts();
    if (acts == acts_seen_) return false;
    acts_seen_ = acts;
    return true;
}

bool GuardLink::is_guard_lost(Silence::Time now) noexcept {
    return silence_.is_too_long(page_.looks(), now) || is_closed(from_guard_);
}

}  // namespace psicarve::guard
