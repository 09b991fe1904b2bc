// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

namespace psicarve::supervisor {

/// Limits the records of a kind: a burst of so many, and then one in each interval. The others are counted,
/// and the count is recorded at most once a minute: so a flood cannot push out what happened before it.
class JournalAllowance {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::uint32_t kMostAtOnce = 500;
    static constexpr std::chrono::seconds kInterval{10};
    static constexpr std::chrono::seconds kTellingInterval{60};

    /// False: the record is counted instead of written.
    bool take(Time now) noexcept {
        if (begun_ == Time{}) begun_ = now;
        const auto regained = static_cast<std::uint64_t>((now - begun_) / kInterval);
        begun_ += regained * kInterval;
        left_ = static_cast<std::uint32_t>(std::min<std::uint64_t>(left_ + regained, kMostAtOnce));
        if (left_ == 0) {
            ++left_out_;
            return false;
        }
        --left_;
        return true;
    }
    /// How many were left out since the last report, when the next report is due; else 0.
    std::uint64_t take_left_out(Time now) noexcept {
        if (left_out_ == 0) return 0;
        if (told_ != Time{} && now - told_ < kTellingInterval) return 0;
        told_ = now;
        return std::exchange(left_out_, 0);
    }
    /// How many were left out, due or not: for the end.
    std::uint64_t take_rest() noexcept { return std::exchange(left_out_, 0); }

private:
    Time begun_{};
    Time told_{};
    std::uint32_t left_ = kMostAtOnce;
    std::uint64_t left_out_ = 0;
};

}  // namespace psicarve::supervisor
