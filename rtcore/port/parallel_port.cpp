// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/parallel_port.hpp"

#include <optional>
#include <utility>

#include "rtcore/clock.hpp"
#include "rtcore/port/fatal_signals.hpp"

namespace psicarve::port {

ParallelPort::ParallelPort(OpenPort open, const PinMap& pin_map)
    : open_(std::move(open)), pin_map_(pin_map), safe_(open_.access(), pin_map), written_(safe_.registers()) {
    watch_over(safe_);
}

ParallelPort::~ParallelPort() {
    safe_.write();
    watch_over(std::nullopt);
}

SignalWord ParallelPort::read_inputs(std::int64_t /*time_ns*/) noexcept {
    std::uint8_t status = 0;
    if (is_healthy_ && open_.access().read_status(status)) return pin_map_.decode_status(status);
    is_healthy_ = false;
    return kInputMask;
}

void ParallelPort::write_outputs(SignalWord levels, std::int64_t /*time_ns*/) noexcept {
    if (fatal_signal_came()) return;
    if (is_healthy_) {
        const OutputRegisters wanted = pin_map_.encode(levels);
        if (write(PortRegister::data, wanted.data, written_.data) &&
            write(PortRegister::control, wanted.control, written_.control)) {
            return;
        }
        is_healthy_ = false;
    }
    safe_.write();
}

void ParallelPort::wait(std::int64_t width_ns) noexcept {
    rtcore::RealClock clock;
    const std::int64_t end_ns = clock.now_ns() + width_ns;
    while (clock.now_ns() < end_ns && !fatal_signal_came()) {
    }
}

bool ParallelPort::write(PortRegister reg, std::uint8_t byte, std::uint8_t& written) noexcept {
    if (byte == written) return true;
    if (!open_.access().write(reg, byte)) return false;
    written = byte;
    return true;
}

}  // namespace psicarve::port
