// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/status_line.hpp"

#include <algorithm>
#include <utility>

namespace psicarve::session {

bool StatusLine::look(const MessageLog& log, Clock::time_point now) {
    const auto& all = log.messages();
    const auto fresh = std::min<std::uint64_t>(log.count() - seen_, all.size());
    seen_ = log.count();
    bool is_other = false;
    for (auto i = all.size() - fresh; i < all.size(); ++i) {
        if (all[i].is_from_before) continue;
        const bool is_trouble = all[i].severity != Severity::info;
        const bool stays = shown_ && shown_->severity != Severity::info && now - since_ < kTroubleStays;
        if (stays && !is_trouble) {
            waiting_ = all[i];
            continue;
        }
        waiting_.reset();
        shown_ = all[i];
        since_ = now;
        is_other = true;
    }
    if (!waiting_ || now - since_ < kTroubleStays) return is_other;
    shown_ = std::exchange(waiting_, std::nullopt);
    since_ = now;
    return true;
}

}  // namespace psicarve::session
