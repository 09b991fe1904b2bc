// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>

namespace psicarve::supervisor {

/// Watches whether more ticks are missed than the profile allows in any second in which the machine moves.
class MissedTicks {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// 0: never too many.
    explicit MissedTicks(std::int64_t allowed_per_s) noexcept : allowed_per_s_(allowed_per_s) {}

    /// Call it repeatedly, with the count so far. True once the limit is passed; it then forgets the ticks
    /// counted, and so it does at rest.
    bool is_too_many(std::uint64_t missed_ticks, bool moves, Time now) {
        const std::uint64_t missed = missed_ticks - missed_seen_;
        missed_seen_ = missed_ticks;
        if (!moves) return forget();
        // It counts as missed now: a gap may have held up this caller as well.
        if (missed > 0) gaps_.push_back({now, missed});
        in_a_second_ += missed;
        while (!gaps_.empty() && now - gaps_.front().seen >= std::chrono::seconds{1}) {
            in_a_second_ -= gaps_.front().ticks;
            gaps_.pop_front();
        }
        const bool is_over = allowed_per_s_ > 0 && in_a_second_ > static_cast<std::uint64_t>(allowed_per_s_);
        if (is_over) forget();
        return is_over;
    }

private:
    struct Gap {
        Time seen;
        std::uint64_t ticks;
    };
    bool forget() {
        gaps_.clear();
        in_a_second_ = 0;
        return false;
    }

    std::int64_t allowed_per_s_;
    std::deque<Gap> gaps_;  ///< of the last second
    std::uint64_t in_a_second_ = 0;
    std::uint64_t missed_seen_ = 0;
};

}  // namespace psicarve::supervisor
