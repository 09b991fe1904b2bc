// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/fine_move.hpp"
#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/pulse_stage.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// Taking up backlash: where a block turns an axis round whose screw has a gap, the motors first cross the
/// gap, from rest to rest, while no tip moves. Planners let a run or a group end where such an axis turns
/// round, so that all this happens at rest. Config and pulses outlive it. RT: yes.
class TakeUp {
public:
    TakeUp(const CycleConfig& config, PulseStage& pulses) noexcept : config_(&config), pulses_(&pulses) {}

    /// Before a block begins. False: none of its axes has a gap to cross. Axes in `still_axes` cross none.
    bool begin(const MotionBlock& block, std::uint32_t still_axes, std::uint64_t tick) noexcept;
    /// Between begin() and end(), or the tick in which step() says that the gaps are crossed.
    bool is_on() const noexcept { return is_on_; }
    void end() noexcept { is_on_ = false; }

    /// Requires is_on(). One tick passes; true once, in the tick of the last pulse.
    bool step(std::uint64_t tick, bool must_slow) noexcept;
    bool is_slowest() const noexcept { return move_.is_slowest(); }
    void rest() noexcept { move_.rest(); }
    /// The planned speed times this, at most 1.
    void set_ratio(double ratio) noexcept { move_.set_ratio(ratio); }
    /// The pins show this way again, after another's.
    void want_directions(std::uint64_t tick) noexcept { pulses_->want_directions(way_pulses_, tick); }

    /// Pulses, with their sign, that a way of `delta_pulses` becomes longer by when the gap is crossed within
    /// it. Before homing it is not known where in its gap an axis stands, and a sensor may trip on the way.
    std::int64_t extra_pulses(std::size_t axis, std::int64_t delta_pulses) const noexcept {
        if (delta_pulses == 0) return 0;
        const bool up = delta_pulses > 0;
        const std::int64_t extra = pulses_->take_up_pulses(axis, up);
        return up ? extra : -extra;
    }

private:
    const CycleConfig* config_;
    PulseStage* pulses_;
    FineMove move_;
    std::array<std::int64_t, kAxisCount> way_pulses_{};
    bool is_on_ = false;
};

}  // namespace psicarve::cycle
