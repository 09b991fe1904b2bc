// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/motion_order.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "shared/program/motion_record.hpp"

namespace psicarve::plan {

/// A motion record that was checked: in pulses, within travel, clear of core and other head.
struct ProgramStep {
    MotionKind kind = MotionKind::end;
    StopReason reason = StopReason::program;  ///< stop
    bool is_rapid = false;
    bool ends_block = false;
    bool is_on = false;           ///< spindle, output
    SwitchedOutputs outputs = 0;  ///< output: which
    std::uint64_t line = 0;       ///< from 1
    std::uint64_t sequence = 0;   ///< of the record, from 1
    Pulses4 target_pulses{};      ///< way: where all axes are after it
    /// Where the program has them beyond that: up to half a pulse, which rounding took or gave.
    std::array<double, kAxisCount> rounded_off_pulses{};
    double seconds = 0.0;       ///< way: the least it may take; dwell: how long
    double tolerance_mm = 0.0;  ///< way: 0: its end is reached to the pulse, at rest
    /// By point-by-point comparison, from rest to rest: a line or an arc of these axes, bit by axis.
    cycle::OrderShape shape = cycle::OrderShape::straight;
    std::uint8_t stepped_axes = 0;
    std::array<std::int64_t, 2> centre_pulses{};  ///< of an arc: its head's, y's
};

/// Which record a motion is of, its line, whether that is a rapid way, and what comes behind it.
struct RecordPlace {
    std::uint64_t line;
    std::uint64_t sequence;
    bool is_rapid;
    std::uint8_t marks;  ///< cycle::kEndsLine, cycle::kOptionalStop
};

/// What a source has to give.
enum class Supply : std::uint8_t {
    step,     ///< the next one
    later,    ///< none yet; more may come
    ended,    ///< none any more: the program's end was given
    lost,     ///< none any more, without an end: who wrote the program is gone
    refused,  ///< none any more: a record was wrong; the source knows which and why
};

/// Gives a program's steps in their order, each once. Planner's thread.
class StepSource {
public:
    virtual ~StepSource() = default;
    /// Once, before the first step: where all axes stand.
    virtual void begin(const Pulses4& /*start_pulses*/) {}
    virtual Supply next(ProgramStep& step) = 0;
};

}  // namespace psicarve::plan
