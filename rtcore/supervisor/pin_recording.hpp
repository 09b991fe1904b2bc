// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <span>

#include "shared/segment/layout.hpp"

namespace psicarve::supervisor {

/// Carries the recording of the pins into the segment, and watches over its reader
/// (shared/machine/recording.hpp). One thread's.
class PinRecording {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// A piece of a trace for the reader with this token; without bytes: the trace is complete.
    void put(SegmentHeader& shared, std::uint32_t token, std::span<const std::uint8_t> bytes, Time now);
    /// True once its reader has been silent for too long; the recording is forgotten.
    bool is_abandoned(const SegmentHeader& shared, Time now) noexcept;
    /// The reader has so much left to read that what comes next could overtake it.
    bool is_reader_behind(const SegmentHeader& shared) const noexcept;

private:
    std::uint32_t token_ = 0;
    std::uint64_t lease_seen_ = 0;
    Time renewed_{};
};

}  // namespace psicarve::supervisor
