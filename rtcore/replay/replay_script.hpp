// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/recorded_gaps.hpp"
#include "shared/machine/status.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::supervisor {

/// One event that reached the tick of a recorded run from outside.
struct ReplayStep {
    enum class Kind : std::uint8_t { request, stop, emergency_stop, inputs, gap };
    std::uint64_t tick;  ///< counted from the beginning of the replay
    Kind kind;
    cycle::RequestKind request;
    std::uint64_t value;  ///< kind gap: ticks that were missed; request fail: the cause; spindle: on or off;
                          ///< end_jog: how
    std::uint64_t gap_count;  ///< kind gap: of how many gaps `value` is the sum
    std::uint8_t axis;
    SignalWord inputs;         ///< kind inputs: all input levels from this tick on
    cycle::MotionOrder order;  ///< jog, jog_on, move
};

/// The content of a recorder, ready to be applied again: from the first moment at which the machine was homed
/// and at rest, to the last entry.
struct ReplayScript {
    std::array<std::int64_t, kAxisCount> start_position_pulses{};
    SignalWord start_levels = 0;  ///< of all pins
    GapsLeft start_gaps{};
    std::vector<ReplayStep> steps;
    std::uint64_t end_tick = 0;    ///< the last entry's
    std::uint64_t first_tick = 0;  ///< tick of the recorded run that is tick 0 here
    bool is_cut = false;           ///< more was recorded, and is not in it
};

/// Nothing when the recorder never saw the machine homed and at rest, or holds nothing after that.
std::optional<ReplayScript> script_from_records(const std::vector<FlightRecord>& records);

/// The same from the rest at which the program of that number was started, if it was the last one; up to the
/// next job, which is another replay's. Nothing when the recorder does not hold that.
std::optional<ReplayScript> script_of_program(const std::vector<FlightRecord>& records,
                                              std::uint64_t program);

}  // namespace psicarve::supervisor
