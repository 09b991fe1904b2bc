// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/job/loaded_job.hpp"

#include "shared/base/message_text.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::size_t kNamedKeys = 4;

std::string differences_text(const std::vector<std::string>& keys) {
    std::string text;
    for (std::size_t i = 0; i < keys.size() && i < kNamedKeys; ++i) text += (i == 0 ? "" : ", ") + keys[i];
    if (keys.size() > kNamedKeys) text += " and " + std::to_string(keys.size() - kNamedKeys) + " more";
    return text;
}

}  // namespace

Result<std::shared_ptr<const LoadedJob>> load_job(std::vector<std::byte> blob, std::uint64_t generation,
                                                  const Profile& core_profile) {
    auto job = std::make_shared<LoadedJob>();
    job->generation = generation;
    job->checksum = job_checksum(blob);
    job->blob = std::move(blob);
    auto view = JobView::check(job->blob);
    if (!view) return view.error();
    job->view = *view;
    const auto profile = job_profile(job->view);
    if (!profile) return profile.error();
    const auto differing = job_differences(*profile, core_profile);
    if (!differing.empty()) {
        return error_from(ErrorCode::machine_refused, with_text(message_of(MessageId::job_for_other_machine),
                                                                differences_text(differing)));
    }
    if (const auto fits = check_job(job->view, core_profile); !fits) return fits.error();
    if (const auto clear = check_heads_clear(profile->blank, core_profile); !clear) return clear.error();
    if (const auto other = blank_difference(profile->blank, core_profile.blank))
        job->remark = blank_difference_message(*other);
    return std::shared_ptr<const LoadedJob>{std::move(job)};
}

}  // namespace psicarve::supervisor
