// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/keyboard_jog.hpp"

#include <utility>

namespace psicarve::session {

void KeyboardJog::arm(Clock::time_point now) noexcept {
    is_armed_ = true;
    held_.reset();
    last_key_ = now;
}

KeyboardJog::Order KeyboardJog::disarm() noexcept {
    is_armed_ = false;
    const bool was_held = std::exchange(held_, std::nullopt).has_value();
    return {was_held ? Order::Kind::release : Order::Kind::none};
}

KeyboardJog::Order KeyboardJog::press(const JogKeyPress& press, Clock::time_point now) noexcept {
    if (!is_armed_ || press.is_repeat) return {};
    last_key_ = now;
    if (held_) {
        held_.reset();
        return {Order::Kind::release};
    }
    const JogWay way = way_of(press.key, press.with_ctrl);
    if (press.with_shift) return {Order::Kind::step, way};
    held_ = press.key;
    return {Order::Kind::hold, way};
}

KeyboardJog::Order KeyboardJog::release(JogKey key, bool is_repeat, Clock::time_point now) noexcept {
    if (!is_armed_ || is_repeat) return {};
    last_key_ = now;
    if (held_ != key) return {};
    held_.reset();
    return {Order::Kind::release};
}

bool KeyboardJog::is_over(Clock::time_point now) const noexcept {
    return is_armed_ && !held_ && now - last_key_ >= kIdleLimit;
}

}  // namespace psicarve::session
