// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/verifier.hpp"

#include <cstdio>
#include <memory>
#include <utility>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/verify/picture.hpp"
#include "shared/snapshot_file.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kText{"verify", "Judge a pin trace against its job, knowing nothing else",
                            "Replays the pins alone into positions, checks what pulses must obey, carves the "
                            "blank in simulation and\n"
                            "compares it with the job's surface. Exit code 6 when something differs.",
                            "psicarve verify figurine.job pins.vcd --picture carved.png"};

struct Options {
    std::string job;
    std::string trace;
    std::string picture;
};

Result<int> verify_files(const CommonOptions& common, const Options& options) {
    if (const auto writable = check_output_folder(options.picture); !writable) return writable.error();
    auto snapshot = load_snapshot(options.job);
    if (!snapshot) return snapshot.error();
    const auto job = job_of_snapshot(std::move(snapshot).value(), options.job, common);
    if (!job) return job.error();
    const auto trace = verify::open_trace(options.trace);
    if (!trace) return trace.error();
    if (!(*trace)->start().has_positions) {
        print_warning(
            options.trace +
            ": does not say where the axes stood at its begin, as "
            "\"$comment position_pulses r1=... r2=... psi=... y=... $end\" would; all are taken to be 0");
    }
    auto verifier = verify::Verifier::make(job->view, job->profile);
    if (!verifier) return bad_input(options.job + ": " + verifier.error().message);
    const auto report = verify::verify_trace(*verifier, **trace);
    if (!report) return report.error();
    if (!options.picture.empty()) {
        const auto caption = verify::caption_of(job->view, *report);
        const auto drawn = verify::write_picture(options.picture, verifier->surface(), caption);
        if (!drawn) return drawn.error();
    }
    std::string text = common.json ? verify::report_json(*report) : verify::report_text(*report);
    if (text.empty() || text.back() != '\n') text += '\n';
    std::printf("%s", text.c_str());
    return report->ok ? kExitDone : kExitDifference;
}

}  // namespace

void add_verify(CommandSet& commands) {
    const auto options = std::make_shared<Options>();
    commands.add(kText, [options](const CommonOptions& common) { return verify_files(common, *options); })
        .argument("JOB", options->job, "The job or snapshot file")
        .argument("TRACE", options->trace, "The pin trace: VCD or compact binary")
        .picture_option(options->picture);
}

}  // namespace psicarve::cli
