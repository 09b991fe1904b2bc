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
#include <thread>
#include <utility>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/program_core.hpp"
#include "hmi/cli/program_report.hpp"
#include "hmi/cli/program_verify.hpp"
#include "hmi/cli/program_watch.hpp"
#include "hmi/cli/record_feeder.hpp"
#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/program_check.hpp"
#include "hmi/machine/recorded_pins.hpp"
#include "hmi/verify/judged_trace.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kGcodeRunText{
    "run", "Runs a program in G-code on the machine",
    "Uses the core that serves the segment, whose axes must be homed. With --simulate it starts one of its\n"
    "own on the simulated machine with the virtual clock, homes it, verifies its pins while it runs, and "
    "ends\n"
    "it.\n"
    "A file is checked to its end before anything moves; standard input is run as it comes, from rest to "
    "rest.\n"
    "Ctrl-C stops the machine; twice is an emergency stop. This command feeds the\n"
    "program to the core: where it is killed, what the core has is run, and the machine comes to rest and "
    "holds.",
    "psicarve gcode run pocket.ngc\n  psicarve gcode run pocket.ngc --from-line 120 --optional-stop\n"
    "  psicarve gcode run pocket.ngc --trace pins.vcd --json"};

constexpr std::chrono::milliseconds kNumberLimit{5000};
constexpr std::chrono::milliseconds kFirstRecordsLook{2};
constexpr int kInputLook_ms = 100;
constexpr const char* kStandardInput = "/dev/stdin";
constexpr std::uint32_t kNoOverride_percent = 100;
constexpr std::uint32_t kMostLine = 4'000'000'000U;

struct GcodeRunOptions {
    std::string path;
    std::string dialect = "ngc";
    std::uint32_t from_line = 0;
    bool is_single = false;
    bool stops_at_optional = false;
    bool skips_deleted = false;
    bool is_dry = false;
    bool is_simulated = false;
    std::string trace;

    bool is_stream() const { return path == "-"; }
};

gcode::Position place_of(const Profile& profile, const CoreStatus& status) {
    const gcode::AxisLetters letters{profile.gcode};
    gcode::Position place{};
    // r1 last: where r2 follows it, one letter stands for both.
    for (const Axis axis : {Axis::r2, Axis::psi, Axis::y, Axis::r1}) {
        place[letters.letter_of(axis)] = static_cast<double>(status.position_pulses[index_of(axis)]) /
                                         axis_motion(profile, axis).pulses_per_unit;
    }
    return place;
}

gcode::InterpreterOptions language_of(const GcodeRunOptions& options, const Profile& profile,
                                      const CoreStatus& status) {
    gcode::InterpreterOptions how;
    how.dialect = options.dialect == "iso" ? gcode::Dialect::iso : gcode::Dialect::ngc;
    how.skips_deleted = options.skips_deleted;
    how.reference = gcode::MachineCheck::reference_of(profile);
    how.start = place_of(profile, status);
    return how;
}

/// The core's numbers are pulses, and its limits are its own.
Result<Profile> profile_of_core(const machine::MachineLink& link, const CommonOptions& common) {
    auto profile = chosen_profile(common);
    if (!profile) return profile;
    if (link.segment().header().core_profile_hash.load() == profile_hash(*profile)) return profile;
    const std::string path = chosen_profile_path(common);
    return Error{ErrorCode::machine_refused, "the core has another profile than " +
                                                 (path.empty() ? "the built-in one" : path) +
                                                 "; name the one that it was started with: --profile FILE"};
}

Result<void> require_ready(const CoreStatus& status) {
    if (status.state == MachineState::ready) return {};
    if (status.state == MachineState::off)
        return error_from(ErrorCode::machine_refused, message_of(MessageId::not_homed));
    if (status.state == MachineState::alarm) return machine::alarm_error(status);
    return error_from(ErrorCode::machine_refused,
                      message_of(MessageId::busy_for_a_job, argument_of(status.state)));
}

/// A dry run switches nothing, so it must be off.
Result<void> require_spindle_off(const GcodeRunOptions& options, const CoreStatus& status) {
    if (!options.is_dry || (status.signals & bit_of(Signal::spindle)) == 0) return {};
    return Error{ErrorCode::machine_refused,
                 "the spindle is on; for a dry run switch it off: psicarve spindle off"};
}

/// Where one letter moves both heads they must begin alike: the first move would drive R2 where nobody sent
/// it.
Result<void> require_heads_alike(const Profile& profile, const CoreStatus& status) {
    const gcode::AxisLetters letters{profile.gcode};
    if (letters.letter_of(Axis::r1) != letters.letter_of(Axis::r2)) return {};
    const auto place = [&](Axis axis) {
        return static_cast<double>(status.position_pulses[index_of(axis)]) /
               axis_motion(profile, axis).pulses_per_unit;
    };
    const double pulse_mm = 1.0 / std::min(axis_motion(profile, Axis::r1).pulses_per_unit,
                                           axis_motion(profile, Axis::r2).pulses_per_unit);
    if (std::abs(place(Axis::r1) - place(Axis::r2)) <= pulse_mm) return {};
    return Error{
        ErrorCode::machine_refused,
        "r2 follows r1 (profile: gcode.second_head), and they stand at different radii; bring them to "
        "one radius: psicarve move"};
}

Error interrupted_before_it_began() {
    return {ErrorCode::cancelled, "interrupted; nothing has moved"};
}

/// Judges a program for as long as nobody interrupts it.
class PatientCheck : public gcode::CanonSink {
public:
    PatientCheck(gcode::CanonSink& check, const OperatorBreak& operator_break) noexcept
        : check_(check), operator_break_(operator_break) {}

    void take(const gcode::CanonRecord& record) override { check_.take(record); }
    void end_block() override { check_.end_block(); }
    bool wants_more() const noexcept override { return !operator_break_.was_asked() && check_.wants_more(); }

private:
    gcode::CanonSink& check_;
    const OperatorBreak& operator_break_;
};

/// Reads the whole file before the first pulse. Nothing: it is wrong, and that was told.
Result<std::optional<gcode::ProgramFacts>> facts_of_right(const GcodeRunOptions& options,
                                                          const gcode::InterpreterOptions& how,
                                                          const Profile& profile, const CommonOptions& common,
                                                          const OperatorBreak& operator_break) {
    gcode::ProblemList problems;
    gcode::MachineCheck machine{profile, problems};
    auto bytes = gcode::open_program(options.path);
    if (!bytes) return bytes.error();
    gcode::LineSource lines{std::move(bytes).value()};
    PatientCheck check{machine, operator_break};
    const auto facts = gcode::interpret_program(lines, how, check, problems);
    if (!facts) return facts.error();
    if (operator_break.was_asked()) return interrupted_before_it_began();
    print_problems(options.path, problems);
    if (problems.error_count() == 0) return std::optional{*facts};
    if (common.json) print_json_line(check_json(options.path, *facts, problems));
    return std::optional<gcode::ProgramFacts>{};
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

/// So that the core finds something to plan. Nothing was sent to it yet.
Result<void> wait_for_records(const RecordFeeder& feeder, const machine::MachineLink& link,
                              const OperatorBreak& operator_break) {
    while (feeder.records_written() == 0 && !feeder.is_done()) {
        if (operator_break.was_asked()) return interrupted_before_it_began();
        if (const auto core = link.require_core(); !core) return core;
        std::this_thread::sleep_for(kFirstRecordsLook);
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
                       const std::optional<ProgramRun>& run, const PinsJudge& judge) {
    const std::string name = program_name(options.path);
    // A file's warnings were told when it was checked.
    if (options.is_stream() || feeder.problems().error_count() > 0) print_problems(name, feeder.problems());
    if (failure) return *failure;
    if (feeder.problems().error_count() > 0) {
        if (common.json) print_json_line(check_json(name, feeder.facts(), feeder.problems()));
        return kExitBadInput;
    }
    const auto pins = judge();
    if (!pins) return pins.error();
    return report_program_run(common, name, *run, *pins);
}

Result<int> run_read(machine::MachineLink& link, const CommonOptions& common, const GcodeRunOptions& options,
                     const Profile& profile, OperatorBreak& operator_break, const PinsJudge& judge) {
    const auto status = link.status();
    if (!status) return status.error();
    if (const auto ready = require_ready(*status); !ready) return ready.error();
    if (const auto off = require_spindle_off(options, *status); !off) return off.error();
    if (const auto alike = require_heads_alike(profile, *status); !alike) return alike.error();
    const gcode::InterpreterOptions how = language_of(options, profile, *status);
    std::uint64_t line_count = 0;
    auto bytes = Result<gcode::ProgramBytes>{Error{ErrorCode::bad_input, {}}};
    if (options.is_stream()) {
        bytes = gcode::open_program(kStandardInput);
    } else {
        const auto state = gcode::state_of_program(options.path);
        if (!state) return state.error();
        const auto facts = facts_of_right(options, how, profile, common, operator_break);
        if (!facts) return facts.error();
        if (!*facts) return kExitBadInput;
        line_count = (*facts)->line_count;
        bytes = gcode::open_unchanged_program(options.path, *state);
    }
    if (!bytes) return bytes.error();
    auto writer = ProgramWriter::claim(link.segment());
    if (!writer) return writer.error();
    if (const auto begun = writer->begin(kNumberLimit); !begun) return begun.error();
    gcode::RunOptions steps;
    steps.from_line = options.from_line;
    steps.stops_at_optional = options.stops_at_optional;
    steps.is_dry = options.is_dry;
    const int awaited_fd = options.is_stream() ? STDIN_FILENO : -1;
    RecordFeeder feeder{{std::move(bytes).value(), awaited_fd, how, steps}, profile, *writer};
    if (const auto waited = wait_for_records(feeder, link, operator_break); !waited) return waited.error();
    if (feeder.records_written() == 0)
        return report_end(common, options, feeder, feeder.failure(), ProgramRun{}, judge);
    if (operator_break.was_asked()) return interrupted_before_it_began();
    ProgramWatch watch{link, operator_break, line_count};
    const auto ended = run_program(link, {writer->program(), options.is_single, *status}, watch);
    operator_break.let_third_end_us();
    feeder.give_up();
    feeder.wait();
    std::optional<Error> of_run;
    if (!ended) of_run = operator_break.was_asked() ? operator_break.error({}) : ended.error();
    const auto failure =
        failure_of(feeder, link.segment(), writer->program(), program_name(options.path), of_run);
    return report_end(common, options, feeder, failure, ended ? std::optional{*ended} : std::nullopt, judge);
}

/// A stream is gone once it is run, and what begins with a line has ways of its own.
std::string reason_not_to_judge(const GcodeRunOptions& options) {
    if (options.is_stream()) return "standard input cannot be read again";
    if (options.from_line > 1) return "it began with line " + std::to_string(options.from_line);
    if (options.is_dry) return "it was a dry run";
    return {};
}

Result<verify::JudgedProgram> program_to_judge_by(const GcodeRunOptions& options, const Profile& profile,
                                                  std::uint32_t override_percent) {
    return program_of_file(options.path, language_of(options, profile, CoreStatus{}), override_percent);
}

/// On a core of our own: it is homed, and its pins are judged while it runs.
Result<int> run_simulated(const CommonOptions& common, const GcodeRunOptions& options) {
    const auto profile = chosen_profile(common);
    if (!profile) return profile.error();
    ProgramCoreLaunch launch{common.segment, common.group, false, options.trace, std::nullopt};
    const std::string reason = reason_not_to_judge(options);
    if (reason.empty()) {
        auto program = program_to_judge_by(options, *profile, kNoOverride_percent);
        if (!program) return program.error();
        launch.program = std::move(*program);
    }
    OperatorBreak operator_break;
    auto core = ProgramCore::start(std::move(launch), *profile);
    if (!core) return core.error();
    print_note("the machine is simulated");
    if (const auto homed = (*core)->home(operator_break); !homed) return homed.error();
    const auto judge = [&]() -> Result<PinsVerdict> {
        auto report = (*core)->finish();
        if (!report && reason.empty()) return report.error();
        PinsVerdict pins{{}, reason, options.trace};
        if (report) pins.verification = std::move(*report);
        return pins;
    };
    return run_read((*core)->link(), common, options, *profile, operator_break, judge);
}

/// Judges the recording of a running core.
Result<PinsVerdict> judged_recording(const GcodeRunOptions& options, const Profile& profile) {
    PinsVerdict pins{{}, reason_not_to_judge(options), options.trace};
    if (!pins.unverified_reason.empty()) return pins;
    auto program = program_to_judge_by(options, profile, kMostOverride_percent);
    if (!program) return program.error();
    auto trace = verify::open_trace(options.trace);
    if (!trace) return trace.error();
    verify::ProgramVerifier verifier{std::move(*program), profile};
    auto report = verify::judged_trace(verifier, **trace, {});
    if (!report) return report.error();
    pins.verification = std::move(*report);
    return pins;
}

Result<int> run(const CommonOptions& common, const GcodeRunOptions& options) {
    if (options.is_stream() && options.from_line > 1)
        return Error{ErrorCode::bad_usage, "--from-line: for a file; standard input is run as it comes"};
    if (const auto writable = check_output_folder(options.trace); !writable) return writable.error();
    auto link = link_to_core(common);
    if (options.is_simulated) {
        if (link)
            return Error{ErrorCode::bad_usage,
                         "--simulate: a core serves " + common.segment + " already; give another --segment"};
        if (link.error().code != ErrorCode::no_core) return link.error();
        return run_simulated(common, options);
    }
    if (!link) return link.error();
    const auto profile = profile_of_core(*link, common);
    if (!profile) return profile.error();
    OperatorBreak operator_break;
    if (options.is_stream()) {
        if (const auto begun = wait_for_input(*link, operator_break); !begun) return begun.error();
    }
    std::unique_ptr<machine::RecordedPins> recording;
    if (!options.trace.empty()) {
        auto begun = machine::RecordedPins::start_file(*link, options.trace);
        if (!begun) return begun.error();
        recording = std::move(*begun);
    }
    const auto judge = [&]() -> Result<PinsVerdict> {
        if (!recording) return PinsVerdict{{}, "no trace was asked for", {}};
        if (const auto whole = recording->finish_file(); !whole) return whole.error();
        return judged_recording(options, *profile);
    };
    auto done = run_read(*link, common, options, *profile, operator_break, judge);
    // Of a run that failed, too.
    if (recording && !done) (void)recording->finish_file();
    return done;
}

}  // namespace

void add_gcode_run(CommandSet& commands) {
    const auto options = std::make_shared<GcodeRunOptions>();
    commands.add(kGcodeRunText, [options](const CommonOptions& common) { return run(common, *options); })
        .stream("FILE", options->path, "A program in G-code")
        .option("--from-line", options->from_line, 1, kMostLine,
                "Begin with this line; what stands before it counts, but makes no motion")
        .flag("--simulate", options->is_simulated,
              "On a simulated machine of its own, by the virtual clock, homed before")
        .option("--trace", options->trace, "OUT.vcd", "Record every pin: .vcd, or compact binary")
        .flag("--single", options->is_single, "Hold after each block; psicarve resume goes on")
        .flag("--optional-stop", options->stops_at_optional, "Hold at M1")
        .flag("--block-delete", options->skips_deleted, "Leave out blocks that begin with /")
        .flag("--dry-run", options->is_dry,
              "Spindle off, heads outside the blank; table and Y go as they would")
        .choice("--dialect", options->dialect, {"ngc", "iso"},
                "Where controls differ: with iso G70 and G71 are the units (default ngc)");
}

}  // namespace psicarve::cli
