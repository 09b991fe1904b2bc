// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment_program.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

#include "shared/base/message_text.hpp"
#include "shared/computer/process_identity.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

std::uint32_t pid_of_claim(std::uint64_t claim) noexcept {
    return static_cast<std::uint32_t>(claim >> 32U);
}

bool is_claimant_alive(const ProgramControl& control, std::uint64_t claim) noexcept {
    return is_process_alive(pid_of_claim(claim), control.claim_start_time.load());
}

/// The start time goes first: a claim is never seen beside the start time of another process. Where it is
/// freed by two at once it may become 0, and the pid alone decides.
bool free_claim(ProgramControl& control, std::uint64_t claim) noexcept {
    control.claim_start_time.store(0);
    return control.claim.compare_exchange_strong(claim, 0);
}

/// The number in the low half keeps one claim from being taken for a later one of the same process.
std::uint64_t new_claim(ProgramControl& control) noexcept {
    const std::uint64_t number = control.next_claim.fetch_add(1) + 1;
    return (std::uint64_t{own_pid()} << 32U) | static_cast<std::uint32_t>(number);
}

ProgramPut put_of(RingAnswer answer) noexcept {
    switch (answer) {
        case RingAnswer::done:
            return ProgramPut::done;
        case RingAnswer::not_yet:
            return ProgramPut::full;
        case RingAnswer::gone:
            return ProgramPut::no_core;
        default:
            return ProgramPut::damaged;
    }
}

/// Without the profile, which is most of a source.
std::optional<ProgramOrigin> origin_of(const ProgramControl& control, std::uint64_t program) noexcept {
    const auto head = read_record_head<offsetof(ProgramSource, profile)>(control.source);
    std::uint64_t told_program = 0;
    const auto take = [&](std::size_t offset, auto& value) {
        std::memcpy(&value, reinterpret_cast<const char*>(head->data()) + offset, sizeof value);
    };
    if (head) take(offsetof(ProgramSource, program), told_program);
    if (told_program == 0 || told_program != program) return std::nullopt;
    ProgramOrigin origin;
    take(offsetof(ProgramSource, from_line), origin.from_line);
    take(offsetof(ProgramSource, flags), origin.flags);
    take(offsetof(ProgramSource, name), origin.name);
    return origin;
}

}  // namespace

// --- writer ------------------------------------------------------------------------------------------------

Result<ProgramWriter> ProgramWriter::claim(Segment& segment) {
    ProgramControl& control = segment.header().program;
    const std::uint64_t ours = new_claim(control);
    for (int attempt = 0; attempt < kRecordRetries; ++attempt) {
        std::uint64_t found = 0;
        if (control.claim.compare_exchange_strong(found, ours)) {
            control.claim_start_time.store(process_start_time(own_pid()));
            return ProgramWriter{segment, ours};
        }
        if (is_claimant_alive(control, found)) {
            return error_from(ErrorCode::machine_refused,
                              message_of(MessageId::program_has_writer, count_argument(pid_of_claim(found))));
        }
        free_claim(control, found);
    }
    return error_from(ErrorCode::machine_refused, message_of(MessageId::program_ring_damaged));
}

ProgramWriter::ProgramWriter(ProgramWriter&& other) noexcept
    : segment_(std::exchange(other.segment_, nullptr)),
      claim_(other.claim_),
      program_(other.program_),
      core_pid_(other.core_pid_),
      core_start_time_(other.core_start_time_),
      sequence_(other.sequence_),
      has_end_(other.has_end_),
      ring_(other.ring_) {}

ProgramWriter& ProgramWriter::operator=(ProgramWriter&& other) noexcept {
    if (this == &other) return *this;
    release();
    segment_ = std::exchange(other.segment_, nullptr);
    claim_ = other.claim_;
    program_ = other.program_;
    core_pid_ = other.core_pid_;
    core_start_time_ = other.core_start_time_;
    sequence_ = other.sequence_;
    has_end_ = other.has_end_;
    ring_ = other.ring_;
    return *this;
}

ProgramWriter::~ProgramWriter() {
    release();
}

Result<void> ProgramWriter::begin(milliseconds limit) {
    ProgramControl& control = segment_->header().program;
    const Clock::time_point deadline = Clock::now() + limit;
    control.asked.store(claim_);
    event_signal(segment_->header().command_raised);
    for (;;) {
        const std::uint32_t seen = event_count(control.ends.was_taken);
        const auto grant = read_record(control.grant);
        const bool is_new = grant && grant->program != program_;
        if (is_new && grant->claim == claim_ && grant->program != 0) {
            program_ = grant->program;
            core_pid_ = segment_->header().core.pid.load();
            core_start_time_ = segment_->header().core.start_time.load();
            sequence_ = 0;
            has_end_ = false;
            ring_.emplace(segment_->record_ring(), grant->first);
            return {};
        }
        const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
        const bool has_core = segment_->core_pid().has_value();
        if (!has_core || left.count() <= 0) {
            std::uint64_t ours = claim_;
            control.asked.compare_exchange_strong(ours, 0);
            if (!has_core) {
                return error_from(ErrorCode::no_core,
                                  with_text(message_of(MessageId::no_core), segment_->name()));
            }
            const auto limit_ms = static_cast<std::uint64_t>(std::max<std::int64_t>(limit.count(), 0));
            return error_from(ErrorCode::timed_out,
                              message_of(MessageId::no_answer_in_time, ms_argument(limit_ms)));
        }
        event_wait_past(control.ends.was_taken, seen, std::min(left, milliseconds{kPartnerLook}));
    }
}

bool ProgramWriter::accepts() const noexcept {
    return segment_->header().program.running.load() == program_;
}

bool ProgramWriter::has_same_core() const noexcept {
    const ProcessIdentity& core = segment_->header().core;
    return core_pid_ == 0 || (core.pid.load() == core_pid_ && core.start_time.load() == core_start_time_);
}

/// Of a program that is not taken any more: a core that begins ends that of the core before, too.
ProgramPut ProgramWriter::ended() const noexcept {
    return has_same_core() ? ProgramPut::over : ProgramPut::no_core;
}

std::optional<ProgramPut> ProgramWriter::refusal() const noexcept {
    if (segment_ == nullptr || !ring_ || has_end_) return ProgramPut::closed;
    if (!accepts()) return ended();
    return std::nullopt;
}

MotionRecord ProgramWriter::signed_copy(const MotionRecord& record) const noexcept {
    MotionRecord copy = record;
    copy.program = program_;
    copy.sequence = sequence_ + 1;
    copy.check = record_check(copy);
    return copy;
}

ProgramPut ProgramWriter::outcome(RingAnswer answer, const MotionRecord& record) noexcept {
    if (answer == RingAnswer::done) {
        ++sequence_;
        has_end_ = record.kind == MotionKind::end;
    }
    return put_of(answer);
}

ProgramPut ProgramWriter::put(const MotionRecord& record) noexcept {
    if (const auto refused = refusal()) return *refused;
    const auto is_core_there = [this] { return accepts() && segment_->core_pid().has_value(); };
    const RingAnswer answer = ring_->put(signed_copy(record), is_core_there);
    if (answer == RingAnswer::gone && !accepts() && segment_->core_pid()) return ended();
    return outcome(answer, record);
}

ProgramPut ProgramWriter::try_put(const MotionRecord& record) noexcept {
    if (const auto refused = refusal()) return *refused;
    return outcome(ring_->try_put(signed_copy(record)), record);
}

ProgramPut ProgramWriter::put_for(const MotionRecord& record, std::chrono::nanoseconds limit) noexcept {
    if (const auto refused = refusal()) return *refused;
    const RingAnswer answer = ring_->put_for(signed_copy(record), limit);
    if (answer != RingAnswer::not_yet) return outcome(answer, record);
    if (!segment_->core_pid()) return ProgramPut::no_core;
    return accepts() ? ProgramPut::full : ended();
}

Error ProgramWriter::error_of(ProgramPut answer) const {
    switch (answer) {
        case ProgramPut::full:
            return error_from(ErrorCode::timed_out, message_of(MessageId::program_ring_full));
        case ProgramPut::no_core:
            return error_from(ErrorCode::no_core, message_of(MessageId::core_ended));
        case ProgramPut::damaged:
            return error_from(ErrorCode::machine_refused, message_of(MessageId::program_ring_damaged));
        default:
            break;
    }
    const ProgramReport report = segment_ != nullptr ? program_report(*segment_) : ProgramReport{};
    const bool is_ours = report.refusal && report.refusal->program == program_;
    return error_from(ErrorCode::machine_refused, answer == ProgramPut::over && is_ours
                                                      ? report.refusal->said
                                                      : message_of(MessageId::program_is_over));
}

void ProgramWriter::tell(const ProgramModes& modes) noexcept {
    if (segment_ == nullptr || program_ == 0 || !has_same_core()) return;
    ProgramModes ours = modes;
    ours.program = program_;
    write_record(segment_->header().program.modes, ours);
}

void ProgramWriter::tell(const ProgramSource& source) noexcept {
    if (segment_ == nullptr || program_ == 0 || !has_same_core()) return;
    ProgramSource ours = source;
    ours.program = program_;
    write_record(segment_->header().program.source, ours);
}

void ProgramWriter::close() noexcept {
    if (segment_ == nullptr || !ring_) return;
    ProgramControl& control = segment_->header().program;
    control.closed.store(program_);
    event_signal(control.ends.was_put);
    ring_.reset();
}

void ProgramWriter::release() noexcept {
    // A forked child has our claim, but must not release it.
    if (segment_ != nullptr && pid_of_claim(claim_) == own_pid()) {
        ProgramControl& control = segment_->header().program;
        std::uint64_t ours = claim_;
        control.asked.compare_exchange_strong(ours, 0);
        if (control.claim.load() == claim_) free_claim(control, claim_);
        event_signal(control.ends.was_put);
    }
    segment_ = nullptr;
    ring_.reset();
}

ProgramReport program_report(const Segment& segment) noexcept {
    const ProgramControl& control = segment.header().program;
    ProgramReport report;
    report.writer_pid = pid_of_claim(control.claim.load());
    report.running = control.running.load();
    // Before the status: so it is never of a way that comes behind that.
    const auto modes = read_record(control.modes);
    if (const auto progress = read_record(control.progress)) report.progress = *progress;
    if (const auto status = read_record(control.status)) report.status = *status;
    const auto refusal = read_record(control.refusal);
    if (refusal && refusal->program != 0 && refusal->program == report.progress.program)
        report.refusal = *refusal;
    if (modes && modes->program != 0 && modes->program == report.status.program) report.modes = *modes;
    report.origin = origin_of(control, report.status.program);
    report.ring_records = segment.header().capacity_records;
    // Both ends move meanwhile, and either may be overwritten.
    const std::uint64_t taken = control.ends.taken.load();
    const std::uint64_t queued = control.ends.written.load() - taken;
    report.queued = static_cast<std::uint32_t>(std::min<std::uint64_t>(queued, report.ring_records));
    return report;
}

std::shared_ptr<const RecordedSource> recorded_source(const Segment& segment) {
    const ProgramControl& control = segment.header().program;
    // Its numbers belong together only where both are of one program.
    const auto progress = read_record(control.progress);
    const auto source = read_record(control.source);
    if (!progress || !source || source->program == 0 || source->program != progress->program) return nullptr;
    if (source->profile_bytes > kSourceProfileBytes) return nullptr;  // no file could hold it
    auto recorded = std::make_shared<RecordedSource>();
    recorded->taken = progress->taken;
    recorded->record_sum = progress->record_sum;
    recorded->end = progress->end;
    recorded->source = *source;
    return recorded;
}

// --- core --------------------------------------------------------------------------------------------------

bool ProgramFeed::is_left() const noexcept {
    return control_->closed.load() == grant_.program || !has_writer();
}

bool ProgramFeed::has_writer() const noexcept {
    return control_->claim.load() == grant_.claim && is_claimant_alive(*control_, grant_.claim);
}

void ProgramFeed::say(std::uint64_t taken, std::uint64_t line, ProgramEnd end,
                      std::uint64_t record_sum) noexcept {
    write_record(control_->progress, ProgramProgress{.program = grant_.program,
                                                     .taken = taken,
                                                     .line = line,
                                                     .end = static_cast<std::uint32_t>(end),
                                                     .reserved = 0,
                                                     .record_sum = record_sum});
}

void ProgramFeed::say_refusal(std::uint64_t line, const Message& why) noexcept {
    write_record(control_->refusal, ProgramRefusal{.program = grant_.program, .line = line, .said = why});
}

std::optional<std::uint32_t> ProgramDesk::waiting_writer() noexcept {
    ProgramControl& control = segment_->header().program;
    const std::uint64_t claim = control.claim.load();
    if (claim == 0) return std::nullopt;
    if (!is_claimant_alive(control, claim)) {
        free_claim(control, claim);
        return std::nullopt;
    }
    if (control.asked.load() != claim) return std::nullopt;
    return pid_of_claim(claim);
}

bool ProgramDesk::asks_again(std::uint64_t claim) const noexcept {
    return segment_->header().program.asked.load() == claim;
}

std::optional<ProgramFeed> ProgramDesk::open(std::uint64_t first) noexcept {
    ProgramControl& control = segment_->header().program;
    if (!waiting_writer()) return std::nullopt;
    std::uint64_t claim = control.claim.load();
    // A writer that takes its question back has not been given anything.
    if (claim == 0 || !control.asked.compare_exchange_strong(claim, 0)) return std::nullopt;
    const ProgramGrant grant{.claim = claim, .program = ++last_program_, .first = first};
    control.ends.written.store(first);
    control.ends.taken.store(first);
    control.closed.store(0);
    ProgramFeed feed{control, segment_->record_ring(), grant};
    write_record(control.refusal, ProgramRefusal{});
    feed.say(0, 0, ProgramEnd::none, 0);
    control.running.store(grant.program);
    write_record(control.grant, grant);
    event_signal(control.ends.was_taken);
    return feed;
}

void ProgramDesk::end() noexcept {
    ProgramControl& control = segment_->header().program;
    control.running.store(0);
    event_signal(control.ends.was_taken);
}

void ProgramDesk::tell(const ProgramStatus& status) noexcept {
    write_record(segment_->header().program.status, status);
}

void clear_program_of_dead_core(SegmentHeader& header) noexcept {
    ProgramControl& control = header.program;
    control.running.store(0);
    write_record(control.status, ProgramStatus{});
    write_record(control.grant, ProgramGrant{});
    write_record(control.progress, ProgramProgress{});
    write_record(control.refusal, ProgramRefusal{});
    write_record(control.modes, ProgramModes{});
    write_record(control.source, ProgramSource{});
    const std::uint64_t claim = control.claim.load();
    if (claim != 0 && !is_claimant_alive(control, claim)) free_claim(control, claim);
    event_signal(control.ends.was_taken);
}

}  // namespace psicarve
