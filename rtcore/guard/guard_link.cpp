// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/guard/guard_link.hpp"

#include <poll.h>
#include <unistd.h>

#include <utility>

namespace psicarve::guard {

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

bool GuardLink::is_guard_gone() const noexcept {
    pollfd pipe{.fd = from_guard_, .events = POLLIN, .revents = 0};
    return poll(&pipe, 1, 0) > 0 && (pipe.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

bool GuardLink::guard_has_acted() noexcept {
    const std::uint32_t acts = page_.acts();
    if (acts == acts_seen_) return false;
    acts_seen_ = acts;
    return true;
}

}  // namespace psicarve::guard
