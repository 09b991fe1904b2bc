// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/prepared_job.hpp"

#include <utility>

namespace psicarve::cam {

Result<PreparedJob> prepare_blob(std::vector<std::byte> blob, Profile profile, const std::string& path) {
    PreparedJob job;
    job.blob = std::move(blob);
    const auto view = JobView::check(job.blob);
    if (!view) return bad_input(path + ": " + view.error().message);
    job.view = *view;
    job.profile = std::move(profile);
    if (const auto fits = check_job(job.view, job.profile); !fits)
        return bad_input(path + ": " + fits.error().message);
    return job;
}

Result<PreparedJob> prepare_snapshot(Snapshot snapshot, const std::string& path) {
    if (snapshot.job_blob.empty()) return bad_input(path + ": the snapshot holds no job");
    const auto view = JobView::check(snapshot.job_blob);
    if (!view) return bad_input(path + ": " + view.error().message);
    auto own = job_profile(*view);
    if (!own) return bad_input(path + ": " + own.error().message);
    return prepare_blob(std::move(snapshot.job_blob), std::move(own).value(), path);
}

}  // namespace psicarve::cam
