// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "shared/layout.hpp"
#include "shared/shared_record.hpp"

namespace psicarve::supervisor {

/// Writes the flight recorder. Missed ticks that follow each other with nothing between are counted on in one
/// record, so that a recorder holds at least as many records of what the machine did as of ticks that it
/// missed. Whoever reads a counter while it grows has its ticks and gaps of two moments at worst.
class FlightLog {
public:
    void append(FlightRecorder& recorder, const FlightRecord& record) noexcept {
        if (last_.kind != RecordKind::gap || record.kind != RecordKind::gap) {
            last_ = record;
            return append_to_ring(recorder, record);
        }
        constexpr unsigned kMostGaps = std::numeric_limits<std::uint16_t>::max();
        last_.value += record.value;
        last_.code = static_cast<std::uint16_t>(std::min(kMostGaps, unsigned{last_.code} + record.code));
        replace_newest_in_ring(recorder, last_);
    }
    /// Another recorder from now on.
    void begin_anew() noexcept { last_ = FlightRecord{}; }

private:
    FlightRecord last_{};
};

}  // namespace psicarve::supervisor
