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
    if (const auto clear = check_heads_clear(job.profile.blank, job.profile); !clear)
        return bad_input(path + ": " + clear.error().message);
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

Result<PreparedJob> prepare_for(PreparedJob job, Profile machine, const std::string& path) {
    const auto other = blank_difference(job.profile.blank, machine.blank);
    if (job.profile.blank.radius_mm > 0.0) machine.blank = job.profile.blank;  // as the core's ways do
    auto made = prepare_blob(std::move(job.blob), std::move(machine), path);
    if (made && other) made->warnings.push_back(path + ": " + blank_difference_text(*other));
    return made;
}

}  // namespace psicarve::cam
