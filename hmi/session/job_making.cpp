// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_making.hpp"

#include <utility>

#include "hmi/cam/least_time.hpp"
#include "hmi/cam/table_job.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::session {

std::shared_ptr<const cam::PreparedJob> with_least_times(cam::PreparedJob&& job) {
    job.least = cam::least_time_of(job.view, job.profile);
    job.pulses_to_end = cam::pulses_to_end(job.view, job.profile);
    return std::make_shared<const cam::PreparedJob>(std::move(job));
}

Result<std::shared_ptr<const cam::PreparedJob>> read_job(const std::string& path) {
    auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    auto job = cam::prepare_snapshot(std::move(snapshot).value(), path);
    if (!job) return job.error();
    return with_least_times(std::move(*job));
}

Result<std::shared_ptr<const cam::PreparedJob>> prepared(cam::BuiltJob built, const Profile& profile,
                                                         const std::string& source) {
    auto job = cam::prepare_blob(job_blob_from_table(built.table), profile, source);
    if (!job) return job.error();
    job->warnings = std::move(built.report.warnings);
    job->notes = std::move(built.report.notes);
    return with_least_times(std::move(*job));
}

}  // namespace psicarve::session
