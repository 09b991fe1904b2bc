// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "shared/base/result.hpp"
#include "shared/program/motion_record.hpp"

namespace psicarve::gcode {

/// Takes records in the order of their execution.
class RecordSink {
public:
    virtual ~RecordSink() = default;
    virtual Result<void> take(const MotionRecord& record) = 0;
};

/// Gives a record out with the next one, or where its block ends: only then it is known whether it ends its
/// block. A stream may be silent for long behind a block. Numbers them.
class RecordOutlet {
public:
    /// The sink outlives the outlet.
    RecordOutlet(std::uint64_t program, RecordSink& sink) noexcept : sink_(sink), program_(program) {}

    /// Program, sequence, check, and whether it ends its block, are filled in here.
    void put(const MotionRecord& record);
    /// The last record ends its block, whatever follows, and is given out.
    void end_block();
    /// Nothing follows.
    void flush();

    /// How many were put, the one that is held among them.
    std::uint64_t record_count() const noexcept { return sequence_ + (held_ ? 1 : 0); }
    bool has_failed() const noexcept { return failure_.has_value(); }
    /// The first failure of the sink; none is taken after it.
    const std::optional<Error>& failure() const noexcept { return failure_; }
    void fail(Error error);

private:
    void give();

    RecordSink& sink_;
    std::uint64_t program_;
    std::uint64_t sequence_ = 0;
    std::optional<MotionRecord> held_;
    std::optional<Error> failure_;
};

}  // namespace psicarve::gcode
