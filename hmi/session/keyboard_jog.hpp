// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "shared/machine/signal.hpp"

namespace psicarve::session {

enum class JogKey : std::uint8_t { left, right, up, down, page_up, page_down };

struct JogWay {
    Axis axis;
    bool up;
    friend bool operator==(const JogWay&, const JogWay&) = default;
};

/// Arrows turn the table and lift the heads; PgUp and PgDn move R1 out and in, with Ctrl R2.
constexpr JogWay way_of(JogKey key, bool with_ctrl) noexcept {
    switch (key) {
        case JogKey::left:
            return {Axis::psi, false};
        case JogKey::right:
            return {Axis::psi, true};
        case JogKey::up:
            return {Axis::y, true};
        case JogKey::down:
            return {Axis::y, false};
        case JogKey::page_up:
        case JogKey::page_down:
            break;
    }
    return {with_ctrl ? Axis::r2 : Axis::r1, key == JogKey::page_up};
}

/// A key press, as the desktop reports it.
struct JogKeyPress {
    JogKey key;
    bool with_ctrl = false;
    bool with_shift = false;  ///< one step instead of continuous motion
    bool is_repeat = false;   ///< the keyboard's own, while the key is held
};

/// Decides what keys mean while jogging by keyboard is armed. One key at a time moves one axis: a second one
/// ends the motion, and so does the release of the key. Arming ends after a while without a key press.
class KeyboardJog {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds kIdleLimit{30};

    struct Order {
        enum class Kind : std::uint8_t { none, step, hold, release };
        Kind kind = Kind::none;
        JogWay way{Axis::r1, true};
    };

    void arm(Clock::time_point now) noexcept;
    /// Ends any motion: release if there is one.
    Order disarm() noexcept;
    bool is_armed() const noexcept { return is_armed_; }
    bool is_held() const noexcept { return held_.has_value(); }

    Order press(const JogKeyPress& press, Clock::time_point now) noexcept;
    Order release(JogKey key, bool is_repeat, Clock::time_point now) noexcept;
    /// No key was pressed for kIdleLimit.
    bool is_over(Clock::time_point now) const noexcept;

private:
    bool is_armed_ = false;
    std::optional<JogKey> held_;
    Clock::time_point last_key_{};
};

}  // namespace psicarve::session
