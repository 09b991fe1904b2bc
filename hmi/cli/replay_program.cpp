// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/replay_program.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/program_core.hpp"
#include "hmi/cli/program_source.hpp"
#include "hmi/cli/program_verify.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/cli/record_feeder.hpp"
#include "hmi/cli/replayed_entries.hpp"
#include "hmi/machine/job_run.hpp"
#include "hmi/machine/private_segment.hpp"
#include "hmi/report/record_text.hpp"
#include "shared/base/units.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/segment/segment_program.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::cli {
namespace {

constexpr std::chrono::milliseconds kReplayNumberLimit{5000};
constexpr std::uint32_t kFull_percent = 100;

using Records = std::vector<FlightRecord>;

/// The recording can be repeated by the text alone.
Result<Records> repeatable_entries(const Snapshot& snapshot, const std::string& path) {
    const ProgramStatus last = recorded_program(snapshot.records);
    if (last.program == 0 && last.line == 0)
        return bad_input(path + ": it recorded no program in G-code; replay it without --program");
    if (snapshot.source == nullptr)
        return bad_input(path +
                         ": it does not say how its program was read, with which switches and work offsets; "
                         "an older psicarve ran it");
    const std::uint64_t program = snapshot.source->source.program;
    Records entries = entries_of_program(snapshot.records, program);
    if (entries.empty() && last.program != 0)
        return bad_input(path +
                         ": its last program to move was another one than the last to be read; how "
                         "that was read it does not say");
    if (entries.empty()) return bad_input(path + ": its flight recorder has lost the begin of the program");
    for (const FlightRecord& entry : entries) {
        const bool has_starved = is_of_program(entry, ProgramEvent::held) &&
                                 program_detail_of(entry) == static_cast<std::uint8_t>(ProgramHold::starved);
        if (has_starved)
            return bad_input(path + ": the machine had to wait for the program in line " +
                             std::to_string(entry.value) +
                             "; what it did from there on followed from the pauses of its writer, which are "
                             "not recorded");
    }
    return entries;
}

/// Nothing: its pins are judged.
std::string reason_unjudged(const SourcedProgram& program, const Records& entries, const Records& all) {
    if (program.is_stream) return "it came from standard input";
    if (program.steps.from_line > 1) return "it began with line " + std::to_string(program.steps.from_line);
    if (program.steps.is_dry) return "it was a dry run";
    const auto is_end = [](const FlightRecord& entry) { return is_program_done(entry); };
    if (std::ranges::none_of(entries, is_end)) return "its end was not recorded";
    const auto is_missed = [&](const FlightRecord& record) {
        return record.kind == RecordKind::gap && record.tick >= entries.front().tick;
    };
    if (std::ranges::any_of(all, is_missed)) return "ticks were missed while it ran";
    const auto is_held = [](const FlightRecord& entry) {
        return entry.kind == RecordKind::state_change &&
               static_cast<MachineState>(entry.code) == MachineState::held;
    };
    if (program.profile.job.lifts_on_hold && std::ranges::any_of(entries, is_held))
        return "the heads were lifted while it was held";
    return {};
}

std::uint32_t most_override_percent(const Snapshot& snapshot) {
    std::uint32_t most = kFull_percent;
    for (const FlightRecord& record : snapshot.records) {
        const bool is_override = record.kind == RecordKind::command &&
                                 static_cast<CommandKind>(record.code) == CommandKind::override;
        if (is_override && record.value <= kMostOverride_percent)
            most = std::max(most, static_cast<std::uint32_t>(record.value));
    }
    return most;
}

Records records_of(const Segment& segment) {
    Records records;
    RingReader reader{segment.header().recorder};
    while (const auto record = reader.next()) records.push_back(*record);
    return records;
}

/// A machine in time writes as many lines as it has seconds, give or take one.
EntryComparison compared(const Records& recorded, const Records& replayed) {
    const EntryComparison all = compare_entries(recorded, replayed);
    if (!all.first_other) return all;
    const auto without_lines = [](Records entries) {
        std::erase_if(entries,
                      [](const FlightRecord& entry) { return is_of_program(entry, ProgramEvent::line); });
        return entries;
    };
    return compare_entries(without_lines(recorded), without_lines(replayed));
}

/// From the program's begin to the last that is told of it.
double span_seconds(const Records& entries, std::int64_t period_ns) {
    if (entries.empty()) return 0.0;
    return seconds_from_ns(static_cast<std::int64_t>(entries.back().tick - entries.front().tick) * period_ns);
}

struct ReplayedProgram {
    ProgramStatus status{};
    double seconds = 0.0;
    EntryComparison entries;
    std::uint64_t untold_ticks = 0;  ///< by which entries may lie apart
    std::optional<verify::ProgramVerifyReport> verification;
    std::string unverified_reason;
    std::optional<Error> failure;  ///< the alarm in which the recording ends, too
    std::string trace;
};

nlohmann::ordered_json replay_json(const std::string& name, const ReplayedProgram& run) {
    const auto& other = run.entries.first_other;
    const auto& seen = run.verification;
    nlohmann::ordered_json json{
        {"file", name},
        {"ok", !run.failure && is_as_recorded(run.entries, run.untold_ticks) && (!seen || seen->ok)},
        {"line", run.status.line},
        {"seconds", run.seconds},
        {"as_recorded", is_as_recorded(run.entries, run.untold_ticks)},
        {"events", run.entries.same_count},
        {"most_ticks_apart", run.entries.most_ticks},
        {"ticks_untold", run.untold_ticks},
        {"most_pulses_apart", run.entries.most_pulses},
        {"first_other", other ? report::record_json(*other) : nlohmann::ordered_json(nullptr)}};
    json["verified"] = seen ? nlohmann::ordered_json(seen->ok) : nlohmann::ordered_json(nullptr);
    if (seen) json["verification"] = verify::program_report_json(*seen);
    if (!seen) json["unverified_reason"] = run.unverified_reason;
    if (!run.trace.empty()) json["trace"] = run.trace;
    if (run.failure) json.update(nlohmann::ordered_json::parse(error_json(*run.failure)));
    return json;
}

std::string comparison_text(const ReplayedProgram& run) {
    const EntryComparison& entries = run.entries;
    const std::string count = count_text(entries.same_count, "event");
    if (entries.first_other)
        return "NO: after " + count + " the recording goes on with " +
               report::record_text(*entries.first_other);
    const std::string apart =
        std::to_string(entries.most_ticks) + " ticks and " + std::to_string(entries.most_pulses) + " pulses";
    const std::string of =
        ", of which the recording leaves " + std::to_string(run.untold_ticks) + " ticks untold";
    if (!is_as_recorded(run.entries, run.untold_ticks))
        return "NO: " + count + ", but up to " + apart + " apart" + of;
    if (entries.most_ticks != 0) return "yes: " + count + ", up to " + apart + " apart" + of;
    return "yes: " + count + ", to the tick";
}

void print_replay(const std::string& name, const ReplayedProgram& run) {
    std::printf("%s: replayed up to line %llu, %s of machine time\n", name.c_str(),
                static_cast<unsigned long long>(run.status.line), clock_text(run.seconds).c_str());
    std::printf("recorded   %s\n", comparison_text(run).c_str());
    if (run.verification) {
        const verify::Offence* const first = verify::first_offence_of(run.verification->rules);
        std::printf("verified   %s\n", first == nullptr ? "yes" : ("NO: " + first->sentence).c_str());
    } else {
        std::printf("verified   not verified: %s\n", run.unverified_reason.c_str());
    }
    if (!run.trace.empty()) std::printf("trace      %s\n", run.trace.c_str());
}

int report_replay(const CommonOptions& common, const std::string& name, const ReplayedProgram& run) {
    clear_progress_line();
    if (common.json)
        print_json_line(replay_json(name, run));
    else
        print_replay(name, run);
    if (run.failure) print_error(*run.failure);
    if (run.failure) return exit_code_of(run.failure->code);
    const bool is_wrong =
        !is_as_recorded(run.entries, run.untold_ticks) || (run.verification && !run.verification->ok);
    return is_wrong ? kExitDifference : kExitDone;
}

RecordFeeder::Program program_to_feed(gcode::ProgramBytes bytes, const SourcedProgram& program,
                                      const RecordedSource& recorded, Segment& segment) {
    RecordFeeder::Program fed;
    fed.bytes = std::move(bytes);
    fed.language = program.language;
    fed.run = program.steps;
    fed.ring_records = segment.record_ring().capacity;
    // Its writer was gone.
    if (recorded.end == static_cast<std::uint32_t>(ProgramEnd::lost)) fed.most_records = recorded.taken;
    return fed;
}

/// Feeds the core, which knows by itself when to begin and when it is over.
Result<machine::JobRun> fed_replay(ProgramCore& core, const SourcedProgram& program,
                                   const RecordedSource& recorded, OperatorBreak& operator_break) {
    auto bytes = gcode::open_unchanged_program(program.options.path, *program.options.state);
    if (!bytes) return bytes.error();
    Segment& segment = core.link().segment();
    auto writer = ProgramWriter::claim(segment);
    if (!writer) return writer.error();
    if (const auto begun = writer->begin(kReplayNumberLimit); !begun) return begun.error();
    RecordFeeder feeder{program_to_feed(std::move(*bytes), program, recorded, segment), program.profile,
                        *writer};
    ProgressBar bar{"replaying"};
    const auto watch = [&](const CoreStatus&) -> Result<void> {
        bar.update(0.0, "line " + std::to_string(program_report(segment).status.line));
        if (operator_break.was_asked())
            return Error{ErrorCode::cancelled, "interrupted; it is not replayed whole"};
        return {};
    };
    machine::JobRun run = machine::follow_replay(core.link(), core.process(), watch);
    feeder.give_up();
    feeder.wait();
    return run;
}

}  // namespace

Result<int> replay_program(const CommonOptions& common, const ReplayProgramOptions& options,
                           const Snapshot& snapshot) {
    const auto entries = repeatable_entries(snapshot, options.snapshot);
    if (!entries) return entries.error();
    const RecordedSource& recorded = *snapshot.source;
    const auto program = sourced_program(recorded, options.program, options.snapshot);
    if (!program) return program.error();
    if (const auto same = require_same_records(*program, recorded, options.snapshot); !same)
        return same.error();
    ReplayedProgram replayed;
    replayed.trace = options.trace;
    replayed.unverified_reason = reason_unjudged(*program, *entries, snapshot.records);
    machine::remove_stale_private_segments();
    ProgramCoreLaunch launch{
        machine::private_segment_name(), {}, true, options.trace, std::nullopt, options.snapshot};
    if (replayed.unverified_reason.empty())
        launch.program = program_of_file(options.program, *program->options.state, program->language,
                                         most_override_percent(snapshot));
    OperatorBreak operator_break;
    auto core = ProgramCore::start(std::move(launch), program->profile);
    if (!core) return core.error();
    auto run = fed_replay(**core, *program, recorded, operator_break);
    if (!run) return run.error();
    if (run->failure && run->failure->code != ErrorCode::machine_refused) return *run->failure;
    replayed.failure = run->failure;
    const Segment& segment = (*core)->link().segment();
    replayed.status = program_report(segment).status;
    const Records repeated = entries_of_program(records_of(segment), recorded.source.program);
    replayed.seconds = span_seconds(repeated, run->after.period_ns);
    replayed.entries = compared(*entries, repeated);
    // On a real clock ticks are missed, and the first motion waits for the planner.
    const bool is_of_virtual_clock = snapshot.status && snapshot.status->is_virtual_clock != 0;
    if (!is_of_virtual_clock)
        replayed.untold_ticks = untold_ticks(*entries, snapshot.records, run->after.period_ns);
    auto verification = (*core)->finish();
    if (!verification) return verification.error();
    replayed.verification = std::move(*verification);
    return report_replay(common, options.program, replayed);
}

}  // namespace psicarve::cli
