// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/base/spsc_ring.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::trace {

/// What the tick tells a trace: the levels of all pins after a change, positions that homing defined anew,
/// where a job begins, and where a recording for another process begins and ends.
struct TraceEntry {
    enum class Kind : std::uint32_t { pins, position, begin_binary, begin_vcd, end, job };
    std::uint64_t tick;
    SignalWord levels;
    Kind kind;
    std::uint32_t offset_ns;  ///< inside the tick
    std::uint32_t token;      ///< kinds begin and end: the recording's token; kind job: the lower half of its
                              ///< generation, then its place in TraceThread
    std::array<std::int64_t, kAxisCount> position_pulses;  ///< kinds position and begin
    std::array<std::int64_t, kAxisCount> crossed_pulses;   ///< kind begin: of each axis' gap, downwards
};

inline constexpr std::size_t kTraceRingEntries = 65536;
/// Written by the tick, read by the thread that writes trace files.
using TraceRing = SpscRing<TraceEntry, kTraceRingEntries>;

}  // namespace psicarve::trace
