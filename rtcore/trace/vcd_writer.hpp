// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rtcore/trace/trace_writer.hpp"
#include "shared/trace/trace_output.hpp"

namespace psicarve::trace {

/// A value-change dump (IEEE 1364-2005, 18.2) of logical levels, one scalar wire a signal, timescale 1 ns,
/// without a date. GTKWave and PulseView/sigrok read it.
///
/// Positions stand in $comment sections: the first among the definitions, and one more where homing found
/// positions that differ from what the pulses since then add up to. Only there: libsigrok 0.5.2 stops reading
/// at a $comment among the values.
class VcdWriter final : public TraceWriter {
public:
    VcdWriter(TraceOutput out, const TraceStart& start) noexcept;

    void add(const TraceEntry& entry) noexcept override;
    /// A dump carries no job: viewers would have to read through it, and sigrok stops at it.
    void add_job(const TracedJob&) noexcept override {}
    void flush() noexcept override { out_.flush(); }
    void finish(std::uint64_t end_tick) noexcept override;
    WrittenBytes written_bytes() const noexcept override { return out_.written_bytes(); }
    std::optional<Error> take_error() override { return out_.take_error(); }

private:
    using Positions = std::array<std::int64_t, kAxisCount>;
    void write_definitions() noexcept;
    void write_axes(std::string_view what, const Positions& pulses) noexcept;
    void write_positions(const Positions& pulses) noexcept { write_axes("position_pulses", pulses); }
    void count_pulses(SignalWord levels) noexcept;
    void write_time(std::int64_t time_ns) noexcept;
    void write_levels(SignalWord which, SignalWord levels) noexcept;

    TraceOutput out_;
    std::int64_t period_ns_;
    std::int64_t time_ns_ = 0;
    SignalWord levels_;
    Positions counted_;
};

}  // namespace psicarve::trace
