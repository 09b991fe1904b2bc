// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/settled_offsets.hpp"

#include "shared/computer/process_identity.hpp"
#include "shared/segment/segment_program.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::offsets {
namespace {

Result<ProgramFate> fate_by(const OffsetsOwner& owner, const ProgramIdentity& program) {
    if (program.segment != owner.segment) return ProgramFate::failed;
    const auto segment = Segment::attach(owner.segment, owner.group);
    if (segment) return fate_of(*segment, program);
    if (segment.error().code == ErrorCode::no_core) return ProgramFate::failed;
    return segment.error();
}

/// With what is pending decided, in memory alone.
Result<Settled> decided(const OffsetsPlace& place, const GcodeProfile& letters, const OffsetsOwner& owner) {
    auto read = read_offsets(place, letters);
    if (!read) return read.error();
    Settled settled{std::move(*read), {}};
    auto& pending = settled.offsets.pending;
    if (!pending) return settled;
    const auto fate = fate_by(owner, pending->of);
    if (!fate) return fate.error();
    if (*fate == ProgramFate::running) return settled;
    if (*fate == ProgramFate::ended) settled.offsets.kept = pending->offsets;
    if (*fate == ProgramFate::failed)
        settled.warning = place.path + ": the work offsets that program " +
                          std::to_string(pending->of.program) +
                          " set are not kept: it is not known to have ended in order";
    pending.reset();
    return settled;
}

}  // namespace

ProgramIdentity identity_of(const Segment& segment, std::uint64_t program) {
    const ProcessIdentity& core = segment.header().core;
    return {.segment = segment.name(),
            .boot_id = current_boot_id(),
            .core_pid = core.pid.load(),
            .core_start_time = core.start_time.load(),
            .program = program};
}

Result<ProgramFate> fate_of(const Segment& segment, const ProgramIdentity& program) {
    if (!segment.core_pid() || identity_of(segment, program.program) != program) return ProgramFate::failed;
    const ProgramControl& control = segment.header().program;
    const auto status = read_record(control.status);
    const auto progress = read_record(control.progress);
    if (!status || !progress)
        return Error{ErrorCode::timed_out, "the core's report of its program cannot be read; try again"};
    if (status->program != program.program) return ProgramFate::failed;
    if (status->is_running != 0) return ProgramFate::running;
    const bool is_whole = status->is_done != 0 && progress->program == program.program &&
                          progress->end == static_cast<std::uint32_t>(ProgramEnd::ended);
    return is_whole ? ProgramFate::ended : ProgramFate::failed;
}

Result<Settled> settle_offsets(const OffsetsPlace& place, const GcodeProfile& letters,
                               const OffsetsOwner& owner, const OffsetsLock&) {
    const auto before = read_offsets(place, letters);
    if (!before) return before.error();
    auto settled = decided(place, letters, owner);
    if (!settled || settled->offsets == *before) return settled;
    if (const auto written = write_offsets(place, settled->offsets, letters); !written)
        return written.error();
    return settled;
}

Result<Settled> settled_offsets(const OffsetsPlace& place, const GcodeProfile& letters,
                                const OffsetsOwner& owner) {
    auto read = read_offsets(place, letters);
    if (!read) return read.error();
    if (!read->pending) return Settled{std::move(*read), {}};
    const auto lock = OffsetsLock::take(place, std::chrono::milliseconds{0});
    if (!lock && lock.error().code == ErrorCode::machine_refused) return Settled{std::move(*read), {}};
    if (!lock) return decided(place, letters, owner);
    auto settled = settle_offsets(place, letters, owner, *lock);
    return settled ? settled : decided(place, letters, owner);
}

}  // namespace psicarve::offsets
