// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/parallel_port.hpp"

#include <optional>
#include <utility>

#include "rtcore/port/fatal_signals.hpp"
#include "rtcore/port/persistence.hpp"
#include "rtcore/realtime/clock.hpp"

namespace psicarve::port {

ParallelPort::ParallelPort(OpenPort open, const PinMap& pin_map, const PulseTimes& pulse_times,
                           std::chrono::milliseconds patience)
    : open_(std::move(open)),
      patience_(patience),
      pin_map_(pin_map),
      safe_(open_.access(), pin_map),
      pulse_times_(pulse_times),
      written_(safe_.registers()) {
    watch_over(safe_);
}

ParallelPort::~ParallelPort() {
    write_until_taken(safe_, patience_);
    watch_over(std::nullopt);
}

SignalWord ParallelPort::read_inputs(std::int64_t /*time_ns*/) noexcept {
    std::uint8_t status = 0;
    if (!open_.access().read_status(status)) {
        note_error(0);
        return kInputMask;
    }
    return is_healthy_ ? pin_map_.decode_status(status) : kInputMask;
}

void ParallelPort::write_outputs(SignalWord levels, std::int64_t /*time_ns*/) noexcept {
    const bool has_edges = is_healthy_ && PulseTimes::has_edges(levels_, levels);
    if (has_edges) wait_until(pulse_times_.earliest_ns(levels_, levels));
    if (fatal_signal_came()) return;
    if (is_healthy_) {
        if (write_levels(levels)) {
            if (has_edges) pulse_times_.note(levels_, levels, rtcore::RealClock{}.now_ns());
            levels_ = levels;
            return;
        }
        note_error(levels);
    }
    is_silent_ = true;
    try_safe_state();
}

bool ParallelPort::write_levels(SignalWord levels) noexcept {
    const OutputRegisters wanted = pin_map_.encode(levels);
    if (!write(PortRegister::data, wanted.data, written_.data) ||
        !write(PortRegister::control, wanted.control, written_.control)) {
        return false;
    }
    is_in_doubt_ = false;
    return true;
}

// One of the registers may have taken its byte and the other not.
void ParallelPort::note_error(SignalWord wanted) noexcept {
    if (is_healthy_) stuck_ = levels_ | (wanted & kOutputMask);
    is_healthy_ = false;
    is_silent_ = true;
}

void ParallelPort::try_safe_state() noexcept {
    if (is_healthy_ || !is_silent_ || fatal_signal_came() || !safe_.write()) return;
    is_silent_ = false;
    stuck_ = 0;
    written_ = safe_.registers();
    levels_ = 0;
}

bool ParallelPort::take_up_again() noexcept {
    std::uint8_t status = 0;
    if (is_healthy_) return true;
    if (is_silent_ || !open_.access().read_status(status)) return false;
    is_in_doubt_ = true;
    is_healthy_ = true;
    return true;
}

void ParallelPort::wait(std::int64_t width_ns) noexcept {
    spin_until(rtcore::RealClock{}.now_ns() + width_ns);
}

// A pulse of many ticks may need a longer wait than a processor should spin for.
void ParallelPort::wait_until(std::int64_t instant_ns) const noexcept {
    constexpr std::int64_t kLongestSpin_ns = 200'000;
    const rtcore::RealClock clock;
    if (instant_ns - clock.now_ns() > kLongestSpin_ns) clock.sleep_until_ns(instant_ns);
    spin_until(instant_ns);
}

void ParallelPort::spin_until(std::int64_t instant_ns) noexcept {
    const rtcore::RealClock clock;
    while (clock.now_ns() < instant_ns && !fatal_signal_came()) {
    }
}

bool ParallelPort::write(PortRegister reg, std::uint8_t byte, std::uint8_t& written) noexcept {
    if (byte == written && !is_in_doubt_) return true;
    if (!open_.access().write(reg, byte)) return false;
    written = byte;
    return true;
}

}  // namespace psicarve::port
