// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::verify {

/// No machine counts further; greater numbers in a trace are garbage, and their sums would overflow.
inline constexpr std::int64_t kMostTracePosition_pulses = std::int64_t{1} << 52;
constexpr bool is_trace_position(std::int64_t position_pulses) noexcept {
    return position_pulses <= kMostTracePosition_pulses && position_pulses >= -kMostTracePosition_pulses;
}

/// Nor has any screw such a gap.
constexpr bool is_trace_gap(std::int64_t crossed_pulses) noexcept {
    return crossed_pulses >= 0 && is_trace_position(crossed_pulses);
}

/// One event of a pin trace, whatever its file format. Times never fall from one event to the next.
struct TraceEvent {
    enum class Kind : std::uint32_t {
        pins,      ///< `levels` are the pins from here on
        position,  ///< homing defined the positions anew: the core counts on from `position_pulses`
    };
    std::int64_t time_ns = 0;
    SignalWord levels = 0;  ///< of both kinds
    Kind kind = Kind::pins;
    std::array<std::int64_t, kAxisCount> position_pulses{};  ///< kind position only
};

/// The state that a trace gives before its first event.
struct TraceStart {
    SignalWord initial_levels = 0;
    SignalWord present = 0;  ///< bit by signal: the trace has that wire; others read 0
    bool has_positions = false;
    std::array<std::int64_t, kAxisCount> position_pulses{};  ///< by axis; 0 when the trace does not say
    /// By axis: of its screw's gap, crossed downwards; never negative, 0 when the trace does not say.
    std::array<std::int64_t, kAxisCount> crossed_pulses{};
    std::int64_t period_ns = 0;   ///< the core's tick; 0: unknown
    bool may_carry_jobs = false;  ///< its form and version can carry jobs
};

/// A pin trace as a stream. Memory does not grow with the trace.
class TraceReader {
public:
    virtual ~TraceReader() = default;

    virtual const TraceStart& start() const noexcept = 0;
    /// The file's, for what is wrong with it.
    virtual const std::string& name() const noexcept = 0;

    /// Fills the front of `events` and returns how many; 0 means the trace's proper end. From a pipe it
    /// returns what is there, at least one, and waits only for that one. Garbage and a trace that was cut
    /// off: bad_input with the byte at which it was noticed; events before it were returned by earlier calls.
    virtual Result<std::size_t> read(std::span<TraceEvent> events) = 0;

    /// How often another job began in the part that was read; a job that is carried twice without another
    /// between them began once.
    virtual std::size_t jobs_begun() const noexcept { return 0; }
};

/// Detects the format by content, then by extension (.vcd). "FILE: what is wrong".
Result<std::unique_ptr<TraceReader>> open_trace(const std::string& path);

/// The same from an open descriptor (a pipe that the core still writes). The reader owns and closes it.
/// Blocks until the trace's header is there.
Result<std::unique_ptr<TraceReader>> open_trace_fd(int descriptor, const std::string& name);

}  // namespace psicarve::verify
