// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "shared/machine/status.hpp"

namespace psicarve::replay {

/// The machine's states, from a flight recorder.
class RecordStates {
public:
    RecordStates() = default;
    explicit RecordStates(const std::vector<FlightRecord>& records);

    bool is_empty() const noexcept { return states_.empty(); }
    /// Fills in state, alarm, homing, override, job and dry run of that tick, where entries give them.
    void fill(CoreStatus& status, std::uint64_t tick) const noexcept;
    /// What is carved in that tick, or on hold, is a program in G-code.
    bool runs_program(std::uint64_t tick) const noexcept;

private:
    struct At {
        std::uint64_t tick;
        MachineState state;
        AlarmCause cause;
        std::uint8_t axis;
        std::uint16_t override_percent;
        std::uint16_t rapid_override_percent;
        std::uint64_t generation;
        std::uint64_t alarms;
        std::uint8_t is_dry;
        bool is_program;
    };
    const At* at(std::uint64_t tick) const noexcept;
    std::vector<At> states_;
};

/// While a job is carved, or on hold.
constexpr bool is_at_job(MachineState state) noexcept {
    return state == MachineState::carving || state == MachineState::holding || state == MachineState::held;
}

}  // namespace psicarve::replay
