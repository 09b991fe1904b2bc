// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/core_job.hpp"

#include <chrono>
#include <utility>

#include "hmi/machine/machine_link.hpp"
#include "hmi/session/job_making.hpp"

namespace psicarve::session {
namespace {

using machine::MachineLink;

constexpr std::chrono::milliseconds kJudgePoll{100};
constexpr std::chrono::milliseconds kCopyLimit{2000};

}  // namespace

Result<std::uint64_t> publish_and_wait(const std::string& segment, const std::string& group,
                                       const cam::PreparedJob& job, const std::atomic<bool>& cancels) {
    auto link = MachineLink::attach(segment, group);
    if (!link) return link.error();
    if (const auto core = link->require_core(); !core) return core.error();
    const auto generation = publish_job(link->segment(), job.blob);
    while (generation) {
        const auto accepted = wait_for_acceptance(link->segment(), *generation, kJudgePoll);
        if (accepted) break;
        if (accepted.error().code != ErrorCode::timed_out) return accepted.error();
        if (cancels.load()) return Error{ErrorCode::cancelled, "publishing was cancelled"};
    }
    return generation;
}

Result<std::shared_ptr<const cam::PreparedJob>> job_in_segment(const std::string& segment,
                                                               const std::string& group) {
    auto link = MachineLink::attach(segment, group);
    if (!link) return link.error();
    auto published = copy_current_job(link->segment(), kCopyLimit);
    if (!published) return published.error();
    const auto view = JobView::check(published->blob);
    if (!view) return view.error();
    auto profile = job_profile(*view);
    if (!profile) return profile.error();
    auto job = cam::prepare_blob(std::move(published->blob), std::move(*profile), segment);
    if (!job) return job.error();
    return with_least_times(std::move(*job));
}

}  // namespace psicarve::session
