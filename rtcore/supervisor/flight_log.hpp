// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "shared/machine/recorded_program.hpp"
#include "shared/segment/layout.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::supervisor {

/// Writes the flight recorder, which it is told of missed ticks gap by gap. Gaps with nothing between are
/// counted on in one record, as long as each by itself would have been harmless where the first one was: so
/// their average is no alarm when a replay has them all there, and one that was an alarm stands by itself.
/// Whatever is told, this bounds the counters in a row: each begins where longer gaps are harmless. Whoever
/// reads a counter while it grows has its ticks and gaps of two moments at worst.
///
/// The line in which a program is replaces the one that was told just before. A replay needs none: gaps are
/// counted on past it. So between two other entries are no more lines than counters, and one.
class FlightLog {
public:
    void append(FlightRecorder& recorder, const FlightRecord& record) noexcept {
        if (is_of_program(record, ProgramEvent::line)) return append_line(recorder, record);
        if (!counts_in_gap(record)) {
            gap_ = record;
            is_line_newest_ = false;
            return append_to_ring(recorder, record);
        }
        gap_.value += record.value;
        gap_.code = static_cast<std::uint16_t>(std::min(kMostGaps, unsigned{gap_.code} + record.code));
        replace_in_ring(recorder, is_line_newest_ ? 1 : 0, gap_);
    }
    /// Another recorder from now on.
    void begin_anew() noexcept {
        gap_ = FlightRecord{};
        is_line_newest_ = false;
    }

private:
    static constexpr unsigned kMostGaps = std::numeric_limits<std::uint16_t>::max();

    void append_line(FlightRecorder& recorder, const FlightRecord& record) noexcept {
        if (is_line_newest_) return replace_in_ring(recorder, 0, record);
        is_line_newest_ = true;
        append_to_ring(recorder, record);
    }
    // Of more gaps than can be said the average is too long: at rest alone that is nothing.
    bool counts_in_gap(const FlightRecord& record) const noexcept {
        if (gap_.kind != RecordKind::gap || record.kind != RecordKind::gap) return false;
        if (record.answer == kAlarmingGap || gap_.answer == kAlarmingGap) return false;
        if (gap_.answer == kAnyGap) return true;
        return record.value <= std::int64_t{gap_.answer} && unsigned{gap_.code} + record.code <= kMostGaps;
    }

    FlightRecord gap_{};  ///< the newest entry, or the one before a line; of another kind: no gap is open
    bool is_line_newest_ = false;
};

}  // namespace psicarve::supervisor
