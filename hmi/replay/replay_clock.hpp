// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace psicarve::replay {

/// Speeds to choose from, slowest first; 1: as it was.
inline constexpr std::array kReplaySpeeds{0.1, 1.0, 10.0, 100.0};

/// The operator's place on the timeline, and how it advances.
class ReplayClock {
public:
    /// A new recording: at its begin, at rest, at the speed set before.
    void begin(std::int64_t end_ns) noexcept;

    std::int64_t now_ns() const noexcept { return static_cast<std::int64_t>(now_ns_); }
    std::int64_t end_ns() const noexcept { return end_ns_; }
    bool is_playing() const noexcept { return is_playing_; }
    double speed() const noexcept { return speed_; }

    /// To a time within the recording. Goes on playing if it did.
    void seek(std::int64_t time_ns) noexcept;
    /// At the end it starts from the begin.
    void play() noexcept;
    void pause() noexcept { is_playing_ = false; }
    /// Requires speed > 0.
    void set_speed(double speed) noexcept { speed_ = speed; }
    /// To the next of kReplaySpeeds.
    void faster() noexcept;
    void slower() noexcept;
    /// Real time has passed. Comes to rest at the end.
    void advance(std::int64_t passed_ns) noexcept;

private:
    double now_ns_ = 0.0;  // below 2^53: 104 days
    std::int64_t end_ns_ = 0;
    double speed_ = 1.0;
    bool is_playing_ = false;
};

}  // namespace psicarve::replay
