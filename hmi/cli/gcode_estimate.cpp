// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
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
#include "hmi/cli/program_core.hpp"
#include "hmi/cli/program_reading.hpp"
#include "hmi/cli/program_ready.hpp"
#include "hmi/cli/program_stops.hpp"
#include "hmi/cli/program_verify.hpp"
#include "hmi/cli/program_watch.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/cli/record_feeder.hpp"
#include "hmi/cli/run_offsets.hpp"
#include "hmi/gcode/machine_check.hpp"
#include "hmi/machine/private_segment.hpp"
#include "shared/base/decimals.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CommandText kGcodeEstimateText{
    "estimate", "How long a program in G-code takes, and where it goes, without running it",
    "A private core on the simulated machine runs it by the virtual clock, as gcode run --simulate does, "
    "from "
    "where homing\nends, with the work offsets of the machine. Nothing moves and no running core is "
    "disturbed. "
    "Stops that wait for a person\ntake no time.",
    "psicarve gcode estimate pocket.ngc\n  psicarve gcode estimate pocket.ngc --json"};

constexpr std::chrono::milliseconds kProgramNumberLimit{5000};
constexpr std::size_t kLoweredInText = 5;
constexpr std::size_t kStopsInText = 5;

struct ProgramEstimate {
    double seconds = 0.0;
    double dwell_seconds = 0.0;
    std::uint64_t stop_count = 0;
    std::vector<ProgramStop> stops;
    gcode::ProgramFacts facts;
    verify::ProgramVerifyReport pins;

    double rest_seconds() const { return std::max(0.0, seconds - pins.times.feed_s - pins.times.rapid_s); }
};

/// Whatever the program waits for is done at once: the virtual clock stands still at rest.
void go_on(machine::MachineLink& link, const ProgramReport& report) {
    const ProgramHold hold = report.status.hold;
    if (hold != ProgramHold::program && hold != ProgramHold::optional && hold != ProgramHold::tool_change)
        return;
    // Refused where it goes on already.
    (void)link.send(CommandKind::resume);
}

Result<ProgramRun> run_once(ProgramCore& core, const GcodeRunOptions& options, const Profile& profile,
                            const gcode::KeptOffsets& offsets, std::uint64_t line_count,
                            OperatorBreak& operator_break) {
    machine::MachineLink& link = core.link();
    const auto status = link.status();
    if (!status) return status.error();
    if (const auto alike = require_heads_alike(profile, *status); !alike) return alike.error();
    auto bytes = gcode::open_unchanged_program(options.path, *options.state);
    if (!bytes) return bytes.error();
    auto writer = ProgramWriter::claim(link.segment());
    if (!writer) return writer.error();
    if (const auto begun = writer->begin(kProgramNumberLimit); !begun) return begun.error();
    gcode::RunOptions steps;
    steps.stops_at_optional = options.stops_at_optional;
    RecordFeeder feeder{
        {std::move(bytes).value(), -1, language_of(options, profile, *status, offsets), steps},
        profile,
        *writer};
    if (const auto waited = wait_for_records(feeder, link, operator_break); !waited) return waited.error();
    ProgramWatch watch{link, operator_break, line_count,
                       [&link](const ProgramReport& report) { go_on(link, report); }};
    watch.keep_quiet("estimating");
    auto ended = run_program(link, {writer->program(), options.switches(), *status}, watch);
    feeder.give_up();
    feeder.wait();
    if (!ended && operator_break.was_asked())
        return Error{ErrorCode::cancelled, "interrupted; nothing has moved"};
    if (ended && feeder.failure()) return *feeder.failure();
    return ended;
}

/// Nothing: the program is wrong, and that was told.
Result<std::optional<ProgramEstimate>> estimate_of(const CommonOptions& common,
                                                   const GcodeRunOptions& options, const Profile& profile) {
    const auto kept = kept_offsets(common, profile);
    if (!kept) return kept.error();
    OperatorBreak operator_break;
    ProgramEstimate estimate;
    gcode::InterpreterOptions how = language_of(options, profile, CoreStatus{}, kept->kept);
    how.start = how.reference;
    gcode::ProblemList problems;
    gcode::MachineCheck machine{profile, problems};
    StopFinder stops{machine, options.stops_at_optional};
    auto bytes = gcode::open_unchanged_program(options.path, *options.state);
    if (!bytes) return bytes.error();
    gcode::LineSource lines{std::move(bytes).value()};
    const auto facts = interpret_patiently(lines, how, stops, problems, operator_break);
    if (!facts) return facts.error();
    const std::string name = program_name(options.path);
    print_problems(name, problems);
    if (problems.error_count() > 0) {
        if (common.json) print_json_line(check_json(name, *facts, problems));
        return std::optional<ProgramEstimate>{};
    }
    estimate.facts = *facts;
    estimate.dwell_seconds = stops.dwell_seconds();
    estimate.stop_count = stops.stop_count();
    estimate.stops = stops.stops();
    machine::remove_stale_private_segments();
    auto core = ProgramCore::start({machine::private_segment_name(),
                                    {},
                                    true,
                                    {},
                                    program_of_file(options.path, *options.state, how, 100)},
                                   profile);
    if (!core) return core.error();
    if (const auto homed = (*core)->home(operator_break); !homed) return homed.error();
    const auto run = run_once(**core, options, profile, kept->kept, facts->line_count, operator_break);
    if (!run) return run.error();
    auto pins = (*core)->finish();
    if (!pins) return pins.error();
    estimate.seconds = run->seconds;
    if (*pins) estimate.pins = std::move(**pins);
    return std::optional{std::move(estimate)};
}

double place_of(const Profile& profile, Axis axis, std::int64_t pulses) {
    return static_cast<double>(pulses) / axis_motion(profile, axis).pulses_per_unit;
}

Json json_of(const std::string& name, const Profile& profile, const ProgramEstimate& estimate) {
    const verify::ProgramVerifyReport& pins = estimate.pins;
    Json bounds;
    for (const Axis axis : kAllAxes) {
        const std::size_t k = index_of(axis);
        const std::string key = std::string{psicarve::name_of(axis)} + (axis == Axis::psi ? "_deg" : "_mm");
        bounds[key] = {place_of(profile, axis, pins.bounds.least_pulses[k]),
                       place_of(profile, axis, pins.bounds.most_pulses[k])};
    }
    auto stops = Json::array();
    for (const ProgramStop& stop : estimate.stops) stops.push_back({{"line", stop.line}, {"why", stop.why}});
    return {{"file", name},
            {"lines", estimate.facts.line_count},
            {"motions", estimate.facts.motion_count},
            {"seconds", estimate.seconds},
            {"feed_seconds", pins.times.feed_s},
            {"rapid_seconds", pins.times.rapid_s},
            {"rest_seconds", estimate.rest_seconds()},
            {"dwell_seconds", estimate.dwell_seconds},
            {"bounds", bounds},
            {"lowered_count", pins.lowered_count},
            {"lowered_seconds", pins.lowered_seconds},
            {"lowered", verify::lowered_json(pins.lowered)},
            {"stop_count", estimate.stop_count},
            {"stops", stops}};
}

void print_text(const std::string& name, const Profile& profile, const ProgramEstimate& estimate) {
    const verify::ProgramVerifyReport& pins = estimate.pins;
    std::printf("program    %s: %s, %s\n", name.c_str(),
                count_text(estimate.facts.line_count, "line").c_str(),
                count_text(estimate.facts.motion_count, "motion").c_str());
    std::printf("time       %s\n", clock_text(estimate.seconds).c_str());
    std::printf("of that    feed %s s, rapid %s s, at rest %s s (dwells %s s)\n",
                decimals(pins.times.feed_s, 1).c_str(), decimals(pins.times.rapid_s, 1).c_str(),
                decimals(estimate.rest_seconds(), 1).c_str(), decimals(estimate.dwell_seconds, 1).c_str());
    std::string bounds;
    for (const Axis axis : kAllAxes) {
        const std::size_t k = index_of(axis);
        bounds += (bounds.empty() ? "" : ", ") + std::string{psicarve::name_of(axis)} + " " +
                  decimals(place_of(profile, axis, pins.bounds.least_pulses[k]), 3) + " to " +
                  decimals(place_of(profile, axis, pins.bounds.most_pulses[k]), 3) +
                  (axis == Axis::psi ? " deg" : " mm");
    }
    std::printf("bounds     %s\n", bounds.c_str());
    if (pins.lowered_count > 0)
        std::printf("feed       lowered %s, which costs %s s, most in %s\n",
                    count_text(pins.lowered_count, "time").c_str(), decimals(pins.lowered_seconds, 1).c_str(),
                    verify::lowered_text(pins.lowered, kLoweredInText).c_str());
    if (estimate.stop_count == 0) return;
    std::string stops;
    for (std::size_t n = 0; n < std::min(kStopsInText, estimate.stops.size()); ++n)
        stops += (n == 0 ? "" : ", ") + std::string{"line "} + std::to_string(estimate.stops[n].line) + " (" +
                 std::string{estimate.stops[n].why} + ")";
    if (estimate.stop_count > kStopsInText)
        stops += " and " + std::to_string(estimate.stop_count - kStopsInText) + " more";
    std::printf("waits      for a person %s: %s\n", count_text(estimate.stop_count, "time").c_str(),
                stops.c_str());
}

Result<int> estimate(const CommonOptions& common, const GcodeRunOptions& asked) {
    GcodeRunOptions options = asked;
    const auto profile = chosen_profile(common);
    if (!profile) return profile.error();
    const auto state = gcode::state_of_program(options.path);
    if (!state) return state.error();
    options.state = *state;
    const auto made = estimate_of(common, options, *profile);
    if (!made) return made.error();
    if (!*made) return kExitBadInput;
    clear_progress_line();
    const std::string name = program_name(options.path);
    if (common.json) {
        print_json_line(json_of(name, *profile, **made));
    } else {
        print_text(name, *profile, **made);
    }
    return kExitDone;
}

}  // namespace

void add_gcode_estimate(CommandSet& commands) {
    const auto options = std::make_shared<GcodeRunOptions>();
    commands
        .add(kGcodeEstimateText,
             [options](const CommonOptions& common) { return estimate(common, *options); })
        .input("FILE", options->path, "A program in G-code")
        .flag("--optional-stop", options->stops_at_optional, "M1 is a stop, too")
        .flag("--block-delete", options->skips_deleted, "Leave out blocks that begin with /")
        .choice("--dialect", options->dialect, {"ngc", "iso"},
                "Where controls differ: with iso G70 and G71 are the units (default ngc)");
}

}  // namespace psicarve::cli
