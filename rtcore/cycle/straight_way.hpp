// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/fine_move.hpp"
#include "rtcore/cycle/pulse_stage.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

using SpeedLimits4 = std::array<double, kAxisCount>;  ///< [pulses/tick]

/// Motors' own ways, from rest to rest, as fast as all of them can follow. False: there is no way. RT: yes.
bool start_straight(FineMove& move, const CycleConfig& config,
                    const std::array<std::int64_t, kAxisCount>& way_pulses,
                    const SpeedLimits4& most_per_tick) noexcept;

/// One tick of it; pulses of axes in `still_axes` are not sent. RT: yes.
void step_along(FineMove& move, PulseStage& pulses, std::uint64_t tick, bool must_slow,
                std::uint32_t still_axes = 0) noexcept;

}  // namespace psicarve::cycle
