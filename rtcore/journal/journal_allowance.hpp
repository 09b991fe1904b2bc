// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

namespace psicarve::supervisor {

/// How many records of a kind may be written: so many at once, and then one in each interval. What is too
/// much is counted, and told of at most once a minute: a flood cannot push out what happened before it.
class JournalAllowance {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::uint32_t kMostAtOnce = 500;
    static constexpr std::chrono::seconds kInterval{10};
    static constexpr std::chrono::seconds kTellingInterval{60};

    /// False: it is counted instead.
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
    /// How many were left out since it was told last, when it is time to tell; else 0.
    std::uint64_t take_left_out(Time now) noexcept {
        if (left_out_ == 0) return 0;
        if (told_ != Time{} && now - told_ < kTellingInterval) return 0;
        told_ = now;
        return std::exchange(left_out_, 0);
    }
    /// All of them, at the end.
    std::uint64_t take_rest() noexcept { return std::exchange(left_out_, 0); }

private:
    Time begun_{};
    Time told_{};
    std::uint32_t left_ = kMostAtOnce;
    std::uint64_t left_out_ = 0;
};

}  // namespace psicarve::supervisor
