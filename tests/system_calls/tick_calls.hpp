// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace psicarve::system_calls {

// What a core's tick asks of the kernel. A preloaded library (preload.cpp) watches every thread from its
// first sleep until an instant on, which is the way in which ticks sleep; library and test share this in a
// file.

/// The environment of the program that the library is loaded into: file with a TickCalls.
inline constexpr const char* kCallsVariable = "PSICARVE_TICK_CALLS";

inline constexpr std::size_t kMostNumbers = 512;

struct TickCalls {
    std::atomic<std::uint32_t> threads_watched;
    std::atomic<std::uint32_t> threads_unwatched;  ///< the kernel would not
    std::array<std::atomic<std::uint64_t>, kMostNumbers> by_number;
};

}  // namespace psicarve::system_calls
