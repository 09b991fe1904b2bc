// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// What a test of one output asks for. In a request, and in the flight recorder, it is one number.
struct PinOrder {
    std::uint8_t signal = 0;    ///< an output's Signal
    bool is_on = false;         ///< false: the test ends
    std::uint32_t pulses = 0;   ///< so many; 0: active until the test ends
    std::uint32_t half_ms = 1;  ///< a pulse is active so long, and then inactive so long
};

constexpr std::uint64_t packed(PinOrder order) noexcept {
    return std::uint64_t{order.pulses} << 32U | std::uint64_t{order.half_ms & 0xFFFFU} << 16U |
           (order.is_on ? 0x100U : 0U) | order.signal;
}
constexpr PinOrder pin_order(std::uint64_t packed_order) noexcept {
    return {static_cast<std::uint8_t>(packed_order), (packed_order & 0x100U) != 0,
            static_cast<std::uint32_t>(packed_order >> 32U),
            static_cast<std::uint32_t>(packed_order >> 16U & 0xFFFFU)};
}

/// One output by hand, all others inactive. RT: yes.
class PinTrial {
public:
    /// Requires half_ticks > 0.
    void begin(SignalWord output, std::uint64_t pulses, std::uint64_t half_ticks,
               std::uint64_t now_tick) noexcept {
        output_ = output;
        halves_left_ = pulses > 0 ? 2 * pulses : kForEver;
        half_ticks_ = half_ticks;
        half_begin_tick_ = now_tick;
    }
    /// Every tick. A half lasts longer where ticks were missed: none is left out.
    void advance(std::uint64_t now_tick) noexcept {
        if (halves_left_ == kForEver || now_tick - half_begin_tick_ < half_ticks_) return;
        --halves_left_;
        half_begin_tick_ = now_tick;
    }
    /// The outputs' levels: active first, then inactive.
    SignalWord levels() const noexcept {
        return halves_left_ == kForEver || halves_left_ % 2 == 0 ? output_ : 0;
    }
    /// All pulses are sent.
    bool is_over() const noexcept { return halves_left_ == 0; }

private:
    static constexpr std::uint64_t kForEver = ~std::uint64_t{0};

    SignalWord output_ = 0;
    std::uint64_t halves_left_ = kForEver;
    std::uint64_t half_ticks_ = 1;
    std::uint64_t half_begin_tick_ = 0;
};

}  // namespace psicarve::cycle
