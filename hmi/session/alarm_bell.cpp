// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/alarm_bell.hpp"

#include <algorithm>

namespace psicarve::session {

void AlarmBell::poll(const MessageLog& log) {
    const auto& all = log.messages();
    const auto fresh = std::min<std::uint64_t>(log.count() - seen_, all.size());
    seen_ = log.count();
    const bool has_alarm =
        std::any_of(all.end() - static_cast<std::ptrdiff_t>(fresh), all.end(), [](const Message& message) {
            return message.severity == Severity::alarm && !message.is_from_before;
        });
    if (has_alarm && is_on_) ring_();
}

}  // namespace psicarve::session
