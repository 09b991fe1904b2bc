// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/verifier.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "hmi/cli/carved_piece.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/program_verify.hpp"
#include "hmi/cli/sliced_model.hpp"
#include "hmi/picture/picture.hpp"
#include "hmi/trace/carried_job.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kVerifyText{
    "verify", "Judge a pin trace against its job or program, knowing nothing else",
    "Replays the pins alone into positions, checks what pulses must obey, carves the "
    "blank in simulation and\n"
    "compares it with the job's surface. Exit code 6 when something differs.",
    "psicarve verify pins.trace --picture carved.png\n"
    "psicarve verify pins.trace --program pocket.ngc\n"
    "psicarve verify figurine.job pins.vcd --model figurine.stl --deviation piece.png"};

constexpr std::uint32_t kFromBegin = ~std::uint32_t{0};

struct VerifyOptions {
    std::string job;
    std::string trace;  ///< empty: `job` is a trace that carries its job
    std::string picture;
    PieceFiles files;
    verify::LayerRange layers;
    std::uint32_t from_point = kFromBegin;
    ProgramVerifyOptions program;
};

bool has_layers(const VerifyOptions& options) {
    return options.layers.first != 0 || options.layers.count != 0 || options.from_point != kFromBegin;
}

std::string json_of(const verify::VerifyReport& report, const std::unique_ptr<CarvedPiece>& piece) {
    auto object = nlohmann::ordered_json::parse(verify::report_json(report));
    if (piece && piece->deviation())
        object["deviation"] = nlohmann::ordered_json::parse(piece::deviation_json(*piece->deviation()));
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string text_of(const verify::VerifyReport& report, const std::unique_ptr<CarvedPiece>& piece) {
    std::string text = verify::report_text(report);
    if (!text.empty() && text.back() == '\n') text.pop_back();
    if (!piece) return text;
    if (piece->deviation()) text += "\n  piece: " + piece::deviation_text(*piece->deviation());
    if (piece->files().mesh.empty()) return text;
    return text + "\n" + piece->files().mesh + ": the piece; " +
           std::to_string(std::llround(piece->removed_mm3())) + " mm3 taken off";
}

/// The named file's job, if the trace may be of it; else the trace's own.
Result<Snapshot> load_job_of(const VerifyOptions& options) {
    if (options.job == options.trace && is_snapshot_file(options.job)) {
        return Error{ErrorCode::bad_usage, options.job + " is a job; name its trace, too: psicarve verify " +
                                               options.job + " TRACE"};
    }
    const std::string remedy = "name it as well: psicarve verify JOB " + options.trace;
    if (options.job == options.trace) return load_carried_job(options.trace, remedy);
    auto snapshot = load_job_file(options.job, "name a job or snapshot file instead");
    if (!snapshot) return snapshot;
    const auto fits = verify::check_is_of_trace(options.trace, job_checksum(snapshot->job_blob), options.job);
    return fits ? std::move(snapshot) : fits.error();
}

struct JobToJudge {
    PreparedJob job;
    verify::AskedCarving asked;
};

/// A snapshot that is named as the job tells what was asked for, unless the command line does.
Result<JobToJudge> job_of_trace(const CommonOptions& common, const VerifyOptions& options) {
    auto snapshot = load_job_of(options);
    if (!snapshot) return snapshot.error();
    const std::vector<FlightRecord> records = std::move(snapshot->records);
    const std::uint64_t points_done = snapshot->status ? snapshot->status->points_done : 0;
    auto job = job_of_snapshot(std::move(snapshot).value(), options.job, common, ProfileUse::judge);
    if (!job) return job.error();
    JobToJudge found{std::move(*job), {options.layers}};
    if (has_layers(options)) return found;
    if (const auto asked =
            verify::asked_carving(found.job.view, records, points_done, verify::TraceHolds::the_last_ones))
        found.asked = *asked;
    return found;
}

/// A core's own trace may hold several jobs, and then the command line must say which.
Result<void> check_has_one_job(const VerifyOptions& options, const verify::TraceReader& trace) {
    if (options.job != options.trace || trace.jobs_begun() <= 1) return {};
    return bad_input(options.trace +
                     ": carries several jobs; name the one that it is to be judged by: "
                     "psicarve verify JOB " +
                     options.trace);
}

/// What is drawn and compared is a job's piece.
Result<int> verify_by_program(const CommonOptions& common, const VerifyOptions& options) {
    if (!options.trace.empty() || !options.picture.empty() || options.files.any() || has_layers(options))
        return Error{ErrorCode::bad_usage,
                     "--program: with a trace alone, as psicarve verify TRACE --program FILE"};
    return verify_program(common, options.job, options.program);
}

Result<int> verify_files(const CommonOptions& common, VerifyOptions options) {
    if (!options.program.program.empty()) return verify_by_program(common, options);
    if (options.from_point != kFromBegin) options.layers.first_point = options.from_point;
    std::error_code none;
    if (options.trace.empty() || std::filesystem::equivalent(options.job, options.trace, none))
        options.trace = options.job;
    if (const auto writable = check_output_folder(options.picture); !writable) return writable.error();
    if (const auto writable = check_piece_files(options.files); !writable) return writable.error();
    const auto found = job_of_trace(common, options);
    if (!found) return found.error();
    const PreparedJob* const job = &found->job;
    for (const std::string& warning : job->warnings) print_warning(warning);
    const auto trace = verify::open_trace(options.trace);
    if (!trace) return trace.error();
    if (!(*trace)->start().has_positions) {
        print_warning(
            options.trace +
            ": does not say where the axes stood at its begin, as "
            "\"$comment position_pulses r1=... r2=... psi=... y=... $end\" would; all are taken to be 0");
    }
    auto verifier = verify::Verifier::make_for(job->view, job->profile, found->asked);
    if (!verifier) return bad_input(options.job + ": " + verifier.error().message);
    auto model = model_of_job(options.files.model, *job);
    if (!model) return model.error();
    const auto piece = CarvedPiece::make(*job, std::move(model).value(), options.files);
    if (!piece) return piece.error();
    if (*piece) verifier->set_follower((*piece)->follower());
    const auto report = verify::verify_trace(*verifier, **trace);
    if (!report) return report.error();
    if (const auto one = check_has_one_job(options, **trace); !one) return one.error();
    if (*piece) {
        if (const auto written = (*piece)->finish(); !written) return written.error();
    }
    if (!options.picture.empty()) {
        const auto caption = verify::caption_of(job->view, *report);
        const auto drawn = verify::write_picture(options.picture, verifier->surface(), caption);
        if (!drawn) return drawn.error();
    }
    std::printf("%s\n", common.json ? json_of(*report, *piece).c_str() : text_of(*report, *piece).c_str());
    return report->ok ? kExitDone : kExitDifference;
}

}  // namespace

void add_verify(CommandSet& commands) {
    const auto options = std::make_shared<VerifyOptions>();
    Syntax syntax = commands.add(
        kVerifyText, [options](const CommonOptions& common) { return verify_files(common, *options); });
    syntax
        .input("JOB|TRACE", options->job, "The job or snapshot file; or a trace that carries its job, alone")
        .optional_input("TRACE", options->trace, "The pin trace: VCD or compact binary")
        .picture_option(options->picture)
        .option("--from-layer", options->layers.first, 0, kMaxJobCount - 1,
                "Carving was to begin with layer N, as with psicarve start")
        .option("--from-point", options->from_point, 0, kMaxJobCount - 1, "And with point N of that layer")
        .option("--layers", options->layers.count, 0, kMaxJobCount, "And to end after N layers")
        .option("--program", options->program.program, "FILE",
                "The program in G-code that the trace has, in place of a job")
        .choice("--dialect", options->program.dialect, {"ngc", "iso"},
                "Of the program, as for gcode run (default ngc)")
        .flag("--block-delete", options->program.skips_deleted,
              "Of the program: leave out blocks that begin with /")
        .option(
            "--offsets", options->program.offsets, "FILE",
            "The work offsets that the program began with (default TRACE.offsets, which gcode run writes)")
        .option("--override", options->program.override_percent, 100, 200,
                "The highest override [%] while the program ran (default 100)");
    add_piece_options(syntax, options->files);
}

}  // namespace psicarve::cli
