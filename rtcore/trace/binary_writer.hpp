// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "rtcore/trace/trace_writer.hpp"
#include "shared/trace/trace_format.hpp"
#include "shared/trace/trace_output.hpp"

namespace psicarve::trace {

/// The compact binary form: shared/trace/trace_format.hpp.
class BinaryWriter final : public TraceWriter {
public:
    BinaryWriter(TraceOutput out, const TraceStart& start) noexcept;

    void add(const TraceEntry& entry) noexcept override;
    void add_job(const TracedJob& job) noexcept override;
    void flush() noexcept override { out_.flush(); }
    void finish(std::uint64_t end_tick) noexcept override;
    WrittenBytes written_bytes() const noexcept override { return out_.written_bytes(); }
    std::optional<Error> take_error() override { return out_.take_error(); }

private:
    std::uint8_t* begin_record(std::uint64_t tick, TraceRecordKind kind) noexcept;

    TraceOutput out_;
    std::uint64_t last_tick_ = 0;
    SignalWord levels_;
};

}  // namespace psicarve::trace
