// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/sim/counter.hpp"
#include "rtcore/sim/sim_config.hpp"

namespace psicarve::sim {

/// A limit switch or the table's index. RT: yes.
class Sensor {
public:
    Sensor(const SensorConfig& config, std::int64_t pulses_per_turn, std::int64_t start_pulses) noexcept;

    /// Tells it the axis' position. True when the contact may show something else than before.
    bool move_to(std::int64_t position_pulses, std::int64_t time_ns) noexcept;
    /// What the contact shows at `time_ns`: the truth, chatter after a change, or a fault.
    bool shows(std::int64_t time_ns) noexcept;
    /// When shows() may change without any motion; kForeverNs when it will not.
    std::int64_t next_change_ns(std::int64_t time_ns) const noexcept;

    void set_fault(SensorFault fault) noexcept { config_.fault = fault; }
    std::uint64_t changes() const noexcept { return changes_.count(); }

private:
    bool is_tripped_at(std::int64_t position_pulses) noexcept;

    SensorConfig config_;
    std::int64_t pulses_per_turn_;
    std::int64_t turn_start_pulses_;  ///< index: where the present turn's index begins
    std::int64_t changed_ns_ = -kForeverNs;
    bool tripped_;
    bool shown_;
    Counter changes_;
};

}  // namespace psicarve::sim
