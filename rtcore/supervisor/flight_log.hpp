// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "shared/segment/layout.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::supervisor {

/// Writes the flight recorder, which it is told of missed ticks gap by gap. Gaps with nothing between are
/// counted on in one record, as long as each by itself would have been harmless where the first one was: so
/// their average is no alarm when a replay has them all there, and one that was an alarm stands by itself.
/// Whatever is told, this bounds the counters in a row: each begins where longer gaps are harmless. Whoever
/// reads a counter while it grows has its ticks and gaps of two moments at worst.
class FlightLog {
public:
    void append(FlightRecorder& recorder, const FlightRecord& record) noexcept {
        if (!counts_in_last(record)) {
            last_ = record;
            return append_to_ring(recorder, record);
        }
        last_.value += record.value;
        last_.code = static_cast<std::uint16_t>(std::min(kMostGaps, unsigned{last_.code} + record.code));
        replace_newest_in_ring(recorder, last_);
    }
    /// Another recorder from now on.
    void begin_anew() noexcept { last_ = FlightRecord{}; }

private:
    static constexpr unsigned kMostGaps = std::numeric_limits<std::uint16_t>::max();

    // Of more gaps than can be said the average is too long: at rest alone that is nothing.
    bool counts_in_last(const FlightRecord& record) const noexcept {
        if (last_.kind != RecordKind::gap || record.kind != RecordKind::gap) return false;
        if (record.answer == kAlarmingGap || last_.answer == kAlarmingGap) return false;
        if (last_.answer == kAnyGap) return true;
        return record.value <= std::int64_t{last_.answer} && unsigned{last_.code} + record.code <= kMostGaps;
    }

    FlightRecord last_{};
};

}  // namespace psicarve::supervisor
