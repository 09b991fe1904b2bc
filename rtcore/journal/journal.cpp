// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/journal/journal.hpp"

#include <unistd.h>

#include <array>
#include <cinttypes>
#include <cstdio>
#include <utility>

#include "rtcore/journal/journal_facts.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::seconds kMissedInterval{60};
constexpr std::size_t kMostWaiting =
    1024;  ///< records that wait for the disk: a burst of any kind, and half of another

std::int64_t now_ms() {
    using std::chrono::system_clock;
    return std::chrono::duration_cast<std::chrono::milliseconds>(system_clock::now().time_since_epoch())
        .count();
}

JournalFacts facts_of_start(const JournalStart& start) {
    std::array<char, 17> profile{};
    (void)std::snprintf(profile.data(), profile.size(), "%016" PRIx64, start.profile_hash);
    JournalFacts facts;
    facts.add("version", std::string_view{PSICARVE_VERSION})
        .add("pid", std::int64_t{::getpid()})
        .add("port", start.port_name)
        .add("clock", std::string_view{start.is_virtual_clock ? "virtual" : "real"})
        .add("profile", std::string_view{profile.data()});
    return facts;
}

/// How a job, or a program, ended that was last in this state.
std::string_view ending_of(MachineState last, MachineState entered) noexcept {
    if (entered == MachineState::alarm) return "alarm";
    return last == MachineState::finishing || last == MachineState::carving ? "done" : "stopped";
}

/// Of one that could only be stopped it tells why.
std::string_view ending_of_program(MachineState last, MachineState entered, ProgramHold broken) noexcept {
    const std::string_view how = ending_of(last, entered);
    if (how != "stopped" || !is_for_good(broken)) return how;
    return broken == ProgramHold::refused ? "refused" : "feeder lost";
}

void add_line(JournalFacts& facts, const ProgramStatus& program) {
    facts.add("line", static_cast<std::int64_t>(program.line));
}

/// As the status counts points.
std::int64_t first_point_of(const cycle::Sample& sample, const JobView& job) noexcept {
    return carved_point(job.joining(), job.point_count(), static_cast<std::uint32_t>(sample.first_layer),
                        static_cast<std::uint32_t>(sample.first_step));
}

}  // namespace

Journal::Journal(const JournalStart& start) {
    if (start.place.folder.empty()) return;
    writer_ = std::make_shared<JournalWriter>(start.place);
    thread_ = std::make_unique<rtcore::SideThread>(rtcore::SideThread::Priority::low, kMostWaiting);
    put_always(JournalKind::core, "start", 0, facts_of_start(start));
}

bool Journal::may_put(JournalKind kind) noexcept {
    return writer_ != nullptr &&
           allowances_[static_cast<std::size_t>(kind)].take(std::chrono::steady_clock::now());
}

void Journal::put(JournalKind kind, std::string what, std::uint64_t tick, JournalFacts facts) {
    if (may_put(kind)) put_always(kind, std::move(what), tick, std::move(facts));
}

void Journal::put_always(JournalKind kind, std::string what, std::uint64_t tick, JournalFacts facts) {
    JournalRecord record;
    record.time_ms = now_ms();
    record.tick = tick;
    record.kind = kind;
    record.what = std::move(what);
    record.facts = std::move(facts);
    writer_->note_given();
    const bool is_taken =
        thread_->do_later([writer = writer_, kept = std::move(record)] { writer->write(kept); });
    if (!is_taken) writer_->note_lost(true);
}

void Journal::tell_left_out(JournalKind kind, std::uint64_t count, std::uint64_t tick) {
    JournalFacts facts;
    facts.add("count", static_cast<std::int64_t>(count));
    if (count > 0) put_always(kind, "left out", tick, std::move(facts));
}

void Journal::note_program(const Segment& segment, const cycle::Sample& sample) {
    if (writer_ == nullptr || !is_for_good(sample.program.hold)) return;
    broken_ = sample.program.hold;
    const ProgramReport report = program_report(segment);
    why_broken_ = report.refusal ? report.refusal->said : Message{};
}

void Journal::note_report(const cycle::Report& report, const cycle::Sample& sample, const LoadedJob* job) {
    if (writer_ == nullptr) return;
    const FlightRecord& record = report.record;
    switch (record.kind) {
        case RecordKind::alarm: {
            JournalFacts facts = facts_of_alarm(report);
            if (runs_job(state_)) is_program_ ? add_line(facts, sample.program) : add_progress(facts, sample);
            put(JournalKind::alarm, std::string{name_of(static_cast<AlarmCause>(record.code))}, record.tick,
                std::move(facts));
            break;
        }
        case RecordKind::program:
            note_program_record(record);
            break;
        case RecordKind::state_change:
            note_state(static_cast<MachineState>(record.code), sample, job);
            break;
        case RecordKind::stop:
            put(JournalKind::command, "stop", record.tick, {});
            break;
        case RecordKind::emergency_stop:
            put(JournalKind::command, "estop", record.tick, {});
            break;
        default:
            break;
    }
}

void Journal::note_state(MachineState entered, const cycle::Sample& sample, const LoadedJob* job) {
    const MachineState before = std::exchange(state_, entered);
    if (runs_job(before) == runs_job(entered)) return;
    JournalFacts facts;
    // A job begins with its approach.
    if (runs_job(entered)) is_program_ = entered == MachineState::carving;
    if (is_program_) return note_program_state(before, entered, sample.tick);
    if (job != nullptr && job->generation == sample.job_generation)
        facts.add("source", job->view.source_name());
    if (runs_job(entered)) {
        facts.add("first_layer", static_cast<std::int64_t>(sample.first_layer));
        if (sample.first_step != 0 && job != nullptr && job->generation == sample.job_generation)
            facts.add("first_point", first_point_of(sample, job->view));
        if (sample.is_dry != 0) facts.add("dry", std::int64_t{1});
        return put(JournalKind::job, "started", sample.tick, std::move(facts));
    }
    facts.add("how", ending_of(before, entered));
    add_progress(facts, sample);
    put(JournalKind::job, "ended", sample.tick, std::move(facts));
}

// Each block one at a time, and each wait of a program that comes too slowly, would push out what is older.
void Journal::note_program_record(const FlightRecord& record) {
    const ProgramStatus before = program_;
    take_record(program_, record);
    JournalFacts facts;
    if (is_of_program(record, ProgramEvent::held)) {
        const bool is_one_of_many = program_.hold == ProgramHold::single ||
                                    (program_.hold == ProgramHold::starved && before.starvations > 0);
        if (is_one_of_many) return;
        is_hold_told_ = program_.hold != ProgramHold::starved;  // its end is not told
        if (program_.hold != ProgramHold::none) facts.add("how", name_of(program_.hold));
        add_line(facts, program_);
        put(JournalKind::job, "program held", record.tick, std::move(facts));
    } else if (is_of_program(record, ProgramEvent::resumed) && std::exchange(is_hold_told_, false)) {
        add_line(facts, program_);
        put(JournalKind::job, "program resumed", record.tick, std::move(facts));
    }
}

void Journal::note_program_state(MachineState before, MachineState entered, std::uint64_t tick) {
    JournalFacts facts;
    if (runs_job(entered)) {
        is_hold_told_ = false;
        facts.add("number", static_cast<std::int64_t>(program_.program));
        if (program_.is_single != 0) facts.add("single", std::int64_t{1});
        if (program_.stops_at_optional != 0) facts.add("optional_stop", std::int64_t{1});
        return put(JournalKind::job, "program started", tick, std::move(facts));
    }
    const ProgramHold broken = std::exchange(broken_, ProgramHold::none);
    facts.add("how", ending_of_program(before, entered, broken));
    add_line(facts, program_);
    if (program_.starvations > 0) facts.add("waits", static_cast<std::int64_t>(program_.starvations));
    if (is_for_good(broken)) add_reason(facts, why_broken_);
    put(JournalKind::job, "program ended", tick, std::move(facts));
}

void Journal::note_answer(const ReceivedCommand& received, AnswerKind kind, const Message& why,
                          std::uint64_t tick) {
    // The allowance comes first: a record that is left out costs nothing, least of all in a flood.
    if (!may_put(JournalKind::command)) return;
    JournalFacts facts = facts_of_command(received);
    facts.add("answer", std::string_view{kind == AnswerKind::done ? "done" : "refused"});
    add_reason(facts, why);
    const bool is_known = static_cast<std::uint32_t>(received.command.kind) < kCommandKindCount;
    put_always(JournalKind::command,
               is_known ? std::string{name_of(received.command.kind)} : std::string{"unknown"}, tick,
               std::move(facts));
}

void Journal::note_job(const LoadedJob& job, std::uint64_t tick) {
    if (may_put(JournalKind::job)) put_always(JournalKind::job, "loaded", tick, facts_of_job(job));
}

void Journal::note_refused_job(const Message& why, std::uint64_t tick) {
    JournalFacts facts;
    add_reason(facts, why);
    put(JournalKind::job, "refused", tick, std::move(facts));
}

void Journal::tell_missed(const cycle::Sample& sample) {
    if (sample.missed_ticks == missed_told_) return;
    JournalFacts facts;
    facts.add("count", static_cast<std::int64_t>(sample.missed_ticks - missed_told_))
        .add("total", static_cast<std::int64_t>(sample.missed_ticks));
    missed_told_ = sample.missed_ticks;
    put_always(JournalKind::core, "missed ticks", sample.tick, std::move(facts));
}

void Journal::note_round(const cycle::Sample& sample) {
    if (writer_ == nullptr) return;
    const auto now = std::chrono::steady_clock::now();
    for (std::size_t kind = 0; kind < kJournalKindCount; ++kind)
        tell_left_out(static_cast<JournalKind>(kind), allowances_[kind].take_left_out(now), sample.tick);
    if (now < next_missed_) return;
    next_missed_ = now + kMissedInterval;
    tell_missed(sample);
}

void Journal::note_end(const cycle::Sample& sample) {
    if (writer_ == nullptr) return;
    for (std::size_t kind = 0; kind < kJournalKindCount; ++kind)
        tell_left_out(static_cast<JournalKind>(kind), allowances_[kind].take_rest(), sample.tick);
    tell_missed(sample);
    JournalFacts facts;
    facts.add("state", name_of(sample.state));
    if (sample.state == MachineState::alarm) facts.add("cause", name_of(sample.alarm_cause));
    put_always(JournalKind::core, "end", sample.tick, std::move(facts));
    writer_ = nullptr;
    thread_ = nullptr;  // waits for it
}

}  // namespace psicarve::supervisor
