// SPDX-License-Identifier: GPL-3.0-or-later
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/modes_teller.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/program_core.hpp"
#include "hmi/cli/program_reading.hpp"
#include "hmi/cli/program_ready.hpp"
#include "hmi/cli/program_report.hpp"
#include "hmi/cli/program_source.hpp"
#include "hmi/cli/program_verify.hpp"
#include "hmi/cli/program_watch.hpp"
#include "hmi/cli/record_feeder.hpp"
#include "hmi/cli/run_offsets.hpp"
#include "hmi/cli/start_from_line.hpp"
#include "hmi/machine/recorded_pins.hpp"
#include "hmi/verify/judged_trace.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kGcodeRunText{
    "run", "Runs a program in G-code on the machine",
    "Uses the core that serves the segment, whose axes must be homed. With --simulate it starts one of its\n"
    "own on the simulated machine by the virtual clock, homes it, verifies its pins meanwhile, and ends it.\n"
    "A file is checked to its end before anything moves; standard input is run as it comes, from rest to "
    "rest.\n"
    "Ctrl-C stops the machine; twice is an emergency stop. This command feeds the\n"
    "program to the core: where it is killed, what the core has is run, and the machine comes to rest and "
    "holds.",
    "psicarve gcode run pocket.ngc\n  psicarve gcode run pocket.ngc --from-line 120 --optional-stop\n"
    "  psicarve gcode run pocket.ngc --trace pins.vcd --json"};

constexpr std::chrono::milliseconds kNumberLimit{5000};
constexpr int kInputLook_ms = 100;
constexpr std::uint32_t kNoOverride_percent = 100;
constexpr std::uint32_t kMostLine = 4'000'000'000U;

/// A dry run switches nothing, so it must be off.
Result<void> require_spindle_off(const GcodeRunOptions& options, const CoreStatus& status) {
    if (!options.is_dry || (status.signals & bit_of(Signal::spindle)) == 0) return {};
    return Error{ErrorCode::machine_refused,
                 "the spindle is on; for a dry run switch it off: psicarve spindle off"};
}

/// Of a run from a line: what comes first is told, and confirmed by a person who sees the machine.
Result<void> tell_start(const GcodeRunOptions& options, const Profile& profile,
                        const gcode::Approach& approach, const CoreStatus& status,
                        const OperatorBreak& operator_break) {
    if (options.from_line <= 1) return {};
    if (!approach.is_reached) return gcode::ends_before(options.from_line);
    print_note(start_text({options.from_line, approach, profile.gcode.turns_shortest, options.is_dry,
                           (status.signals & bit_of(Signal::spindle)) != 0}));
    if (options.is_confirmed || options.is_simulated) return {};
    return confirm_start(operator_break);
}

/// What was told of the machine must still hold once a person has answered.
Result<void> require_unchanged(machine::MachineLink& link, const CoreStatus& told) {
    const auto now = link.status();
    if (!now) return now.error();
    if (const auto ready = require_ready(link.segment(), *now); !ready) return ready;
    const bool is_same = std::ranges::equal(now->position_pulses, told.position_pulses) &&
                         ((now->signals ^ told.signals) & bit_of(Signal::spindle)) == 0;
    if (is_same) return {};
    return Error{
        ErrorCode::machine_refused,
        "the machine was moved or its spindle switched meanwhile; nothing was begun, give the command "
        "again"};
}

/// A stream begins when its sender does: by then the machine may stand elsewhere.
Result<void> wait_for_input(const machine::MachineLink& link, const OperatorBreak& operator_break) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    while (poll(&input, 1, kInputLook_ms) <= 0) {
        if (operator_break.was_asked()) return interrupted_before_it_began();
        if (const auto core = link.require_core(); !core) return core;
    }
    return {};
}

/// What ended the program early, the first cause before what follows from it.
std::optional<Error> failure_of(const RecordFeeder& feeder, const Segment& segment, std::uint64_t program,
                                const std::string& name, const std::optional<Error>& of_run) {
    const ProgramReport report = program_report(segment);
    const bool is_refused = report.refusal && report.refusal->program == program;
    // What we did not write ourselves is not lost.
    if (is_refused && !(feeder.failure() && report.refusal->said.id == MessageId::program_lost)) {
        const std::string line = std::to_string(report.refusal->line);
        return Error{ErrorCode::machine_refused, name + ":" + line + ": " + in_words(report.refusal->said)};
    }
    if (of_run) return of_run;
    return feeder.failure();
}

/// The program is written and the machine rests again: the report, and the exit code.
Result<int> report_end(const CommonOptions& common, const GcodeRunOptions& options,
                       const RecordFeeder& feeder, const std::optional<Error>& failure,
                       const std::optional<ProgramRun>& run, const PinsWork& work) {
    const std::string name = program_name(options.path);
    // A file's warnings were told when it was checked.
    if (options.is_stream() || feeder.problems().error_count() > 0) print_problems(name, feeder.problems());
    if (failure) return *failure;
    if (feeder.problems().error_count() > 0) {
        if (common.json) print_json_line(check_json(name, feeder.facts(), feeder.problems()));
        return kExitBadInput;
    }
    const auto pins = work.judge(*run);
    if (!pins) return pins.error();
    return report_program_run(common, name, *run, *pins);
}

Result<int> run_read(machine::MachineLink& link, const CommonOptions& common, const GcodeRunOptions& options,
                     const Profile& profile, RunOffsets& offsets, OperatorBreak& operator_break,
                     const PinsWork& work) {
    const auto status = link.status();
    if (!status) return status.error();
    if (const auto ready = require_ready(link.segment(), *status); !ready) return ready.error();
    if (const auto off = require_spindle_off(options, *status); !off) return off.error();
    if (const auto alike = require_heads_alike(profile, *status); !alike) return alike.error();
    const gcode::InterpreterOptions how = language_of(options, profile, *status, offsets.begin());
    std::uint64_t line_count = 0;
    auto bytes = Result<gcode::ProgramBytes>{Error{ErrorCode::bad_input, {}}};
    if (options.is_stream()) {
        bytes = gcode::open_stream(STDIN_FILENO);
    } else {
        const auto read = read_right_program(options, how, profile, common, operator_break);
        if (!read) return read.error();
        if (!*read) return kExitBadInput;
        line_count = (*read)->facts.line_count;
        if (const auto begun = tell_start(options, profile, (*read)->approach, *status, operator_break);
            !begun)
            return begun.error();
        if (const auto same = require_unchanged(link, *status); !same) return same.error();
        bytes = gcode::open_unchanged_program(options.path, *options.state);
    }
    if (!bytes) return bytes.error();
    offsets.tell_begin();
    if (work.begin) {
        if (const auto begun = work.begin(); !begun) return begun.error();
    }
    auto writer = ProgramWriter::claim(link.segment());
    if (!writer) return writer.error();
    if (const auto held = offsets.hold(); !held) return held.error();
    if (const auto begun = writer->begin(kNumberLimit); !begun) return begun.error();
    if (const auto told = tell_source(*writer, options, profile, *status, offsets.begin()); !told)
        return told.error();
    gcode::RunOptions steps;
    steps.from_line = options.from_line;
    steps.stops_at_optional = options.stops_at_optional;
    steps.is_dry = options.is_dry;
    const int awaited_fd = options.is_stream() ? STDIN_FILENO : -1;
    const auto promise = [&](const gcode::KeptOffsets& left) {
        offsets.promise(left, link.segment(), writer->program());
    };
    RecordFeeder feeder{
        {std::move(bytes).value(), awaited_fd, how, steps, promise, link.segment().record_ring().capacity},
        profile,
        *writer};
    // Nothing was asked of the core yet.
    const auto leave = [&] {
        feeder.give_up();
        feeder.wait();
        (void)offsets.finish(feeder.offsets(), false, link.segment(), writer->program());
    };
    auto waited = wait_for_records(feeder, link, operator_break);
    if (waited && operator_break.was_asked()) waited = interrupted_before_it_began();
    if (!waited || feeder.records_written() == 0) leave();
    if (!waited) return waited.error();
    if (feeder.records_written() == 0)
        return report_end(common, options, feeder, feeder.failure(), ProgramRun{}, work);
    ModesTeller teller{feeder.trail(), *writer};
    ProgramWatch watch{link, operator_break, line_count,
                       [&teller](const ProgramReport& report) { teller.follow(report); }};
    const auto ended = run_program(link, {writer->program(), options.switches(), *status}, watch);
    operator_break.let_third_end_us();
    teller.follow(program_report(link.segment()));
    feeder.give_up();
    feeder.wait();
    std::optional<Error> of_run;
    if (!ended) of_run = operator_break.was_asked() ? operator_break.error({}) : ended.error();
    const auto failure =
        failure_of(feeder, link.segment(), writer->program(), program_name(options.path), of_run);
    const bool is_in_order = !failure && feeder.problems().error_count() == 0;
    const auto kept = offsets.finish(feeder.offsets(), is_in_order, link.segment(), writer->program());
    auto reported =
        report_end(common, options, feeder, failure, ended ? std::optional{*ended} : std::nullopt, work);
    if (kept) return reported;
    // It has moved all the same: that is told first.
    print_error(kept.error());
    if (reported && *reported == kExitDone) return kExitMachine;
    return reported;
}

/// A stream is gone once it is run, and what begins with a line has ways of its own.
std::string reason_not_to_judge(const GcodeRunOptions& options) {
    if (options.is_stream()) return "standard input cannot be read again";
    if (options.from_line > 1) return "it began with line " + std::to_string(options.from_line);
    if (options.is_dry) return "it was a dry run";
    return {};
}

/// The same once it was run.
std::string reason_not_to_judge(const GcodeRunOptions& options, const Profile& profile,
                                const ProgramRun& run) {
    std::string reason = reason_not_to_judge(options);
    if (reason.empty() && run.was_held && profile.job.lifts_on_hold)
        reason = "the heads were lifted while it was held";
    return reason;
}

verify::JudgedProgram program_to_judge_by(const GcodeRunOptions& options, const Profile& profile,
                                          const RunOffsets& offsets, std::uint32_t override_percent) {
    return program_of_file(options.path, *options.state,
                           language_of(options, profile, CoreStatus{}, offsets.begin()), override_percent);
}

/// Of a run that did not come to be judged the trace is finished, too.
Result<int> with_trace(Result<int> done, const Result<void>& trace) {
    if (trace) return done;
    if (done) return trace.error();
    print_warning(trace.error().message);
    return done;
}

/// A trace of old is not lost for a program that is wrong.
Result<bool> is_worth_a_trace(const CommonOptions& common, const GcodeRunOptions& options,
                              const Profile& profile, const RunOffsets& offsets,
                              const OperatorBreak& operator_break) {
    if (options.trace.empty() || options.is_stream()) return true;
    gcode::InterpreterOptions how = language_of(options, profile, CoreStatus{}, offsets.begin());
    how.start = how.reference;
    const auto read = read_right_program(options, how, profile, common, operator_break);
    if (!read) return read.error();
    if (*read && options.from_line > 1 && !(*read)->approach.is_reached)
        return gcode::ends_before(options.from_line);
    return read->has_value();
}

/// On a core of our own: it is homed, and its pins are judged while it runs.
Result<int> run_simulated(const CommonOptions& common, const GcodeRunOptions& options) {
    const auto profile = chosen_profile(common);
    if (!profile) return profile.error();
    auto offsets = RunOffsets::read(common, *profile, false);
    if (!offsets) return offsets.error();
    OperatorBreak operator_break;
    const auto worth = is_worth_a_trace(common, options, *profile, *offsets, operator_break);
    if (!worth) return worth.error();
    if (!*worth) return kExitBadInput;
    const bool is_there = Segment::attach(common.segment).has_value();
    ProgramCoreLaunch launch{common.segment, common.group, !is_there, options.trace, std::nullopt};
    if (reason_not_to_judge(options).empty())
        launch.program = program_to_judge_by(options, *profile, *offsets, kNoOverride_percent);
    auto core = ProgramCore::start(std::move(launch), *profile);
    if (!core) return core.error();
    print_note("the machine is simulated");
    if (const auto homed = (*core)->home(operator_break); !homed) return homed.error();
    if (options.is_stream()) {
        if (const auto begun = wait_for_input((*core)->link(), operator_break); !begun) return begun.error();
        if (const auto read = offsets->read_again(); !read) return read.error();
    }
    bool is_finished = false;
    const auto judge = [&](const ProgramRun& run) -> Result<PinsVerdict> {
        is_finished = true;
        auto report = (*core)->finish();
        if (!report) return report.error();
        PinsVerdict pins{{}, reason_not_to_judge(options, *profile, run), options.trace, true};
        if (pins.unverified_reason.empty() && run.most_override_percent > kNoOverride_percent)
            pins.unverified_reason =
                "the feed was raised to " + std::to_string(run.most_override_percent) + " % while it ran";
        if (pins.unverified_reason.empty()) pins.verification = std::move(*report);
        return pins;
    };
    auto done = run_read((*core)->link(), common, options, *profile, *offsets, operator_break, {{}, judge});
    if (is_finished) offsets->write_beside(options.trace);
    if (is_finished || options.trace.empty()) return done;
    const auto report = (*core)->finish();
    offsets->write_beside(options.trace);
    const bool is_lost = !report && report.error().code == ErrorCode::out_of_room;
    return with_trace(std::move(done), is_lost ? Result<void>{report.error()} : Result<void>{});
}

/// Judges the recording of a running core.
Result<PinsVerdict> judged_recording(const GcodeRunOptions& options, const Profile& profile,
                                     const RunOffsets& offsets, const ProgramRun& run) {
    PinsVerdict pins{{}, reason_not_to_judge(options, profile, run), options.trace};
    if (!pins.unverified_reason.empty()) return pins;
    auto trace = verify::open_trace(options.trace);
    if (!trace) return trace.error();
    const std::uint32_t most_percent = std::max(run.most_override_percent, kNoOverride_percent);
    verify::ProgramVerifier verifier{program_to_judge_by(options, profile, offsets, most_percent), profile};
    auto report = verify::judged_trace(verifier, **trace, {});
    if (!report) return report.error();
    if (report->failure) return *report->failure;
    pins.verification = std::move(*report);
    return pins;
}

Result<int> run_on_core(machine::MachineLink& link, const CommonOptions& common,
                        const GcodeRunOptions& options) {
    const auto profile = profile_of_core(link, common);
    if (!profile) return profile.error();
    OperatorBreak operator_break;
    operator_break.take_hang_up();
    if (options.is_stream()) {
        if (const auto begun = wait_for_input(link, operator_break); !begun) return begun.error();
    }
    auto offsets = RunOffsets::read(common, *profile, !options.is_dry);
    if (!offsets) return offsets.error();
    std::unique_ptr<machine::RecordedPins> recording;
    bool is_finished = false;
    PinsWork work;
    work.begin = [&]() -> Result<void> {
        if (options.trace.empty()) return {};
        auto begun = machine::RecordedPins::start_file(link, options.trace);
        if (!begun) return begun.error();
        recording = std::move(*begun);
        return {};
    };
    work.judge = [&](const ProgramRun& run) -> Result<PinsVerdict> {
        if (!recording) return PinsVerdict{{}, "no trace was asked for", {}};
        is_finished = true;
        if (const auto whole = recording->finish_file(); !whole) return whole.error();
        return judged_recording(options, *profile, *offsets, run);
    };
    auto done = run_read(link, common, options, *profile, *offsets, operator_break, work);
    if (!recording) return done;
    const auto whole = is_finished ? Result<void>{} : recording->finish_file();
    offsets->write_beside(options.trace);
    return is_finished ? std::move(done) : with_trace(std::move(done), whole);
}

Result<int> run(const CommonOptions& common, const GcodeRunOptions& asked) {
    GcodeRunOptions options = asked;
    if (options.is_stream() && options.from_line > 1)
        return Error{ErrorCode::bad_usage, "--from-line: for a file; standard input is run as it comes"};
    if (options.is_confirmed && options.from_line == 0)
        return Error{ErrorCode::bad_usage, "--unattended is for --from-line"};
    if (options.from_line > 1 && !options.is_confirmed && !options.is_simulated && !can_ask())
        return Error{
            ErrorCode::bad_usage,
            "--from-line: nobody is there to confirm what the machine does first; run it on a terminal, "
            "or with --unattended"};
    if (const auto writable = check_output_folder(options.trace); !writable) return writable.error();
    auto link = link_to_core(common);
    if (options.is_simulated && link)
        return Error{ErrorCode::bad_usage,
                     "--simulate: a core serves " + common.segment + " already; give another --segment"};
    if (!link && (!options.is_simulated || link.error().code != ErrorCode::no_core)) return link.error();
    if (!options.is_stream()) {
        const auto state = gcode::state_of_program(options.path);
        if (!state) return state.error();
        options.state = *state;
    }
    return options.is_simulated ? run_simulated(common, options) : run_on_core(*link, common, options);
}

}  // namespace

void add_gcode_run(CommandSet& commands) {
    const auto options = std::make_shared<GcodeRunOptions>();
    commands.add(kGcodeRunText, [options](const CommonOptions& common) { return run(common, *options); })
        .stream("FILE", options->path, "A program in G-code")
        .option("--from-line", options->from_line, 1, kMostLine,
                "Begin with this line; what stands before it counts, but makes no motion")
        .flag("--unattended", options->is_confirmed,
              "With --from-line: do not ask before the machine does what comes first")
        .flag("--simulate", options->is_simulated,
              "On a simulated machine of its own, by the virtual clock, homed before")
        .option("--trace", options->trace, "OUT.vcd", "Record every pin: .vcd, or compact binary")
        .flag("--single", options->is_single, "Hold after each block; psicarve resume goes on")
        .flag("--optional-stop", options->stops_at_optional,
              "Hold at each M1 until psicarve optional-stop off")
        .flag("--block-delete", options->skips_deleted, "Leave out blocks that begin with /")
        .flag("--dry-run", options->is_dry,
              "Spindle off, heads outside the blank; table and Y go as they would")
        .flag("--mdi", options->is_typed, "Tell status that FILE is a block that was typed")
        .choice("--dialect", options->dialect, {"ngc", "iso"},
                "Where controls differ: with iso G70 and G71 are the units (default ngc)");
}

}  // namespace psicarve::cli
