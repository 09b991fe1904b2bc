// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace psicarve::supervisor {

/// Watches the count of missed ticks for more than the profile allows in a second.
class MissedTicks {
public:
    /// 0: never too many.
    explicit MissedTicks(std::int64_t allowed_per_s) noexcept : allowed_per_s_(allowed_per_s) {}

    /// True once for each second in which the limit was passed.
    bool is_too_many(std::uint64_t missed_ticks, std::chrono::steady_clock::time_point now) noexcept {
        if (now - window_start_ >= std::chrono::seconds{1}) {
            window_start_ = now;
            // As it was when last looked at: a gap that held us up as well belongs to the new second.
            missed_at_start_ = missed_seen_;
            has_told_ = false;
        }
        missed_seen_ = missed_ticks;
        const bool is_over = allowed_per_s_ > 0 &&
                             missed_ticks - missed_at_start_ > static_cast<std::uint64_t>(allowed_per_s_);
        if (!is_over || has_told_) return false;
        has_told_ = true;
        return true;
    }

private:
    std::int64_t allowed_per_s_;
    std::chrono::steady_clock::time_point window_start_{};
    std::uint64_t missed_at_start_ = 0;
    std::uint64_t missed_seen_ = 0;
    bool has_told_ = false;
};

}  // namespace psicarve::supervisor
