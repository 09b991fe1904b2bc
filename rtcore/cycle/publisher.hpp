// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// When the sample is renewed: every sample_ticks, and in the tick that asks for it. Positions that changed
/// since then go into the increment queue; what finds it full is counted as lost. io outlives it. RT: yes.
class Publisher {
public:
    using Positions = std::array<std::int64_t, kAxisCount>;

    Publisher(CycleIo& io, std::uint64_t sample_ticks) noexcept : io_(&io), sample_ticks_(sample_ticks) {}

    bool is_due(std::uint64_t tick) const noexcept { return tick >= next_tick_; }
    /// At the end of this tick, whenever else it were due.
    void ask(std::uint64_t tick) noexcept { next_tick_ = tick; }

    /// Comes before the sample, which tells what is lost.
    void publish_positions(const Positions& now_pulses, std::uint64_t tick) noexcept {
        next_tick_ = tick + sample_ticks_;
        if (now_pulses == published_pulses_) return;
        published_pulses_ = now_pulses;
        const IncrementEntry entry{.tick = tick,
                                   .r1_pulses = static_cast<std::int32_t>(now_pulses[0]),
                                   .r2_pulses = static_cast<std::int32_t>(now_pulses[1]),
                                   .psi_pulses = now_pulses[2],
                                   .y_pulses = now_pulses[3]};
        if (!io_->increments.push(entry)) ++increments_lost_;
    }
    void publish(const Sample& sample) noexcept { io_->sample.write(sample); }

    std::uint64_t increments_lost() const noexcept { return increments_lost_; }

private:
    CycleIo* io_;
    std::uint64_t sample_ticks_;
    std::uint64_t next_tick_ = 0;
    Positions published_pulses_{};
    std::uint64_t increments_lost_ = 0;
};

}  // namespace psicarve::cycle
