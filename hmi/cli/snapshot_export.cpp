// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/report/job_export.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kSnapshotExportText{
    "export", "The job's tables on standard output, as CSV or JSON",
    "CSV: one row a point. psi_pulses is the absolute table position; it grows on "
    "across layers when joining is\n"
    "continuous.",
    "psicarve snapshot export figurine.job --format csv > figurine.csv"};

struct SnapshotExportOptions {
    std::string path;
    std::string format = "csv";
};

Result<int> export_job(const SnapshotExportOptions& options) {
    const auto snapshot = load_snapshot(options.path);
    if (!snapshot) return snapshot.error();
    if (snapshot->job_blob.empty()) return bad_input(options.path + ": the snapshot holds no job");
    const auto job = JobView::check(snapshot->job_blob);
    if (!job) return bad_input(options.path + ": " + job.error().message);
    if (options.format == "json") {
        report::write_json(*job, stdout);
    } else {
        report::write_csv(*job, stdout);
    }
    return kExitDone;
}

}  // namespace

void add_snapshot_export(CommandSet& commands) {
    const auto options = std::make_shared<SnapshotExportOptions>();
    commands.add_plain(kSnapshotExportText, [options](const CommonOptions&) { return export_job(*options); })
        .input("FILE", options->path, "A snapshot or job file")
        .choice("--format", options->format, {"csv", "json"}, "Default csv");
}

}  // namespace psicarve::cli
