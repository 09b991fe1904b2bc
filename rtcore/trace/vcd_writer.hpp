// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "rtcore/trace/fd_writer.hpp"
#include "rtcore/trace/trace_writer.hpp"

namespace psicarve::trace {

/// A value-change dump (IEEE 1364-2005, 18.2) of logical levels, one scalar wire a signal, timescale 1 ns,
/// without a date. Positions stand in $comment lines. GTKWave and PulseView/sigrok read it.
class VcdWriter final : public TraceWriter {
public:
    VcdWriter(FdWriter out, const TraceStart& start) noexcept;

    void add(const TraceEntry& entry) noexcept override;
    void flush() noexcept override { out_.flush(); }
    void finish(std::uint64_t end_tick) noexcept override;
    std::optional<Error> take_error() override { return out_.take_error(); }

private:
    using Positions = std::array<std::int64_t, kAxisCount>;
    void write_definitions() noexcept;
    void write_positions(const Positions& pulses) noexcept;
    void write_time(std::int64_t time_ns) noexcept;
    void write_levels(SignalWord which, SignalWord levels) noexcept;

    FdWriter out_;
    std::int64_t period_ns_;
    std::int64_t time_ns_ = 0;
    SignalWord levels_;
};

}  // namespace psicarve::trace
