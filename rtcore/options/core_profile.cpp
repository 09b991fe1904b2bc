// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/options/core_profile.hpp"

#include "shared/job/job.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::supervisor {

Result<Profile> load_core_profile(const std::string& path) {
    if (path.empty()) return Profile{};
    if (!is_snapshot_file(path)) return load_profile(path);
    const auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    if (snapshot->job_blob.empty()) return bad_input(path + ": holds no job, and so no profile");
    const auto job = JobView::check(snapshot->job_blob);
    if (!job) return job.error();
    return job_profile(*job);
}

}  // namespace psicarve::supervisor
