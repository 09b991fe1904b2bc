// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hmi/trace/backlash.hpp"
#include "hmi/trace/trace_reader.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::replay {

/// The machine at one instant of a trace, as the pins alone show it.
struct PinMoment {
    std::int64_t time_ns = 0;
    SignalWord levels = 0;
    std::array<std::int64_t, kAxisCount> position_pulses{};  ///< the tips', as the core counts them
    std::array<std::uint64_t, kAxisCount> pulses{};          ///< since the trace began
    std::uint32_t definitions = 0;                           ///< how often homing defined the positions

    friend bool operator==(const PinMoment&, const PinMoment&) = default;
};

/// Follows a trace from event to event. Its state depends only on the events so far.
class PinFollower {
public:
    /// `profile`: gives this machine's backlash, since pulses that only cross a gap move no tip.
    PinFollower(const verify::TraceStart& start, const Profile& profile);

    void take(const verify::TraceEvent& event) noexcept;
    const PinMoment& moment() const noexcept { return moment_; }

private:
    void pulse(Axis axis) noexcept;

    PinMoment moment_;
    verify::Backlash backlash_;
};

}  // namespace psicarve::replay
