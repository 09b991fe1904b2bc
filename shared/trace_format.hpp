// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "shared/signal.hpp"

namespace psicarve {

// The compact binary pin trace. Little-endian.
//
//   header   TraceHeader, 64 bytes
//   records  each begins with a LEB128 number N:
//              N = 2*d     pins: d ns-free ticks have passed since the last record; then LEB128 of (old XOR
//              new) SignalWord N = 2*d+1   position: d ticks have passed; then 4 zig-zag LEB128 positions r1
//              r2 psi y [pulses]: what the
//                          core counts from here on (homing defined it anew), pins unchanged
//            an offset inside the tick follows a pins record only when bit 31 of the XOR word is set: LEB128
//            [ns]
//   end      N = 2^63 (ten bytes) as a terminator: a trace without it was cut off
//
// Time of a record [ns] = tick * period_ns + offset.

inline constexpr std::uint64_t kTraceMagic = 0x3143525441435350ULL;  // "PSCATRC1"
inline constexpr std::uint32_t kTraceVersion = 1;
inline constexpr std::uint64_t kTraceEnd = std::uint64_t{1} << 63;
inline constexpr SignalWord kTraceOffsetFlag = SignalWord{1} << 31;

struct TraceHeader {
    std::uint64_t magic;
    std::uint32_t version;
    SignalWord initial_levels;  ///< all signals at tick 0
    std::int64_t period_ns;
    std::int64_t position_pulses[kAxisCount];  ///< as counted before the first value
    std::uint64_t reserved;
};
static_assert(sizeof(TraceHeader) == 64);

}  // namespace psicarve
