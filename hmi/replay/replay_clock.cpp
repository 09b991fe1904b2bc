// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/replay_clock.hpp"

#include <algorithm>

namespace psicarve::replay {

void ReplayClock::begin(std::int64_t end_ns) noexcept {
    end_ns_ = end_ns;
    now_ns_ = 0.0;
    is_playing_ = false;
}

void ReplayClock::seek(std::int64_t time_ns) noexcept {
    now_ns_ = static_cast<double>(std::clamp<std::int64_t>(time_ns, 0, end_ns_));
}

void ReplayClock::play() noexcept {
    if (now_ns() >= end_ns_) now_ns_ = 0.0;
    is_playing_ = end_ns_ > 0;
}

void ReplayClock::faster() noexcept {
    const auto* const next = std::upper_bound(kReplaySpeeds.begin(), kReplaySpeeds.end(), speed_);
    if (next != kReplaySpeeds.end()) speed_ = *next;
}

void ReplayClock::slower() noexcept {
    const auto* const same = std::lower_bound(kReplaySpeeds.begin(), kReplaySpeeds.end(), speed_);
    if (same != kReplaySpeeds.begin()) speed_ = *(same - 1);
}

void ReplayClock::advance(std::int64_t passed_ns) noexcept {
    if (!is_playing_ || passed_ns <= 0) return;
    now_ns_ += speed_ * static_cast<double>(passed_ns);
    if (now_ns_ < static_cast<double>(end_ns_)) return;
    now_ns_ = static_cast<double>(end_ns_);
    is_playing_ = false;
}

}  // namespace psicarve::replay
