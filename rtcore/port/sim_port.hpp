// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/port/port.hpp"
#include "rtcore/sim/machine.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/pin_map.hpp"

namespace psicarve::port {

/// A parallel port whose connector leads to a simulated machine: levels become register bytes, and these
/// alone reach the machine. Table look-ups only. The machine outlives the port. RT: yes.
class SimPort final : public Port {
public:
    SimPort(const PinMap& pin_map, sim::Machine& machine);

    SignalWord read_inputs(std::int64_t time_ns) noexcept override {
        return pin_map_.decode_status(machine_->read_status(time_ns));
    }
    void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept override {
        const OutputRegisters registers = pin_map_.encode(levels);
        machine_->write_registers(registers.data, registers.control, time_ns);
    }
    void wait(std::int64_t /*width_ns*/) noexcept override {}
    bool is_healthy() const noexcept override { return true; }

private:
    PinMap pin_map_;
    sim::Machine* machine_;
};

}  // namespace psicarve::port
