// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/port/open_port.hpp"
#include "rtcore/port/port.hpp"
#include "rtcore/port/port_access.hpp"
#include "shared/pin_map.hpp"
#include "shared/signal.hpp"

namespace psicarve::port {

/// A real parallel port. Writes only registers that change, and the safe state last of all. After the first
/// error it writes nothing but the safe state any more, and shows every input tripped. RT: yes, all but
/// construction and destruction.
class ParallelPort final : public Port {
public:
    /// The port holds the safe state already, as open_port() leaves it.
    ParallelPort(OpenPort open, const PinMap& pin_map);
    ~ParallelPort() override;
    ParallelPort(const ParallelPort&) = delete;
    ParallelPort& operator=(const ParallelPort&) = delete;

    SignalWord read_inputs(std::int64_t time_ns) noexcept override;
    void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept override;
    /// Spins: a sleep would take longer than a pulse.
    void wait(std::int64_t width_ns) noexcept override;
    bool is_healthy() const noexcept override { return is_healthy_; }

private:
    bool write(PortRegister reg, std::uint8_t byte, std::uint8_t& written) noexcept;

    OpenPort open_;
    PinMap pin_map_;
    SafeState safe_;
    OutputRegisters written_;
    bool is_healthy_ = true;
};

}  // namespace psicarve::port
