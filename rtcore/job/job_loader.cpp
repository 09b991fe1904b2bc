// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/job/job_loader.hpp"

#include <utility>

#include "shared/base/message_text.hpp"

namespace psicarve::supervisor {
namespace {

/// What a job's structure or its profile's text is wrong in is said by a text alone.
Message message_for(const Error& error) {
    return error.said.is_none() ? with_text(message_of(MessageId::job_unsound), error.message) : error.said;
}

JobLoader::Outcome look_at(Segment& segment, std::uint64_t known_generation, std::uint64_t generation,
                           const Profile& profile) {
    JobLoader::Outcome outcome;
    auto taken = take_published_job(segment, known_generation);
    if (!taken) {
        outcome.generation = generation;
        outcome.is_published = is_published(segment, generation);
        outcome.refusal = message_for(taken.error());
        return outcome;
    }
    if (!taken->has_value()) return outcome;
    PublishedJob& published = **taken;
    outcome.generation = published.generation;
    outcome.is_published = true;
    auto job = load_job(std::move(published.blob), published.generation, profile);
    if (job) {
        outcome.job = std::move(*job);
    } else {
        outcome.refusal = message_for(job.error());
    }
    return outcome;
}

}  // namespace

JobLoader::JobLoader(const Profile& profile, bool has_thread) : profile_(std::make_shared<Profile>(profile)) {
    // An operator waits for it.
    if (has_thread) thread_ = std::make_unique<rtcore::SideThread>(rtcore::SideThread::Priority::ordinary);
}

void JobLoader::begin(std::shared_ptr<Segment> segment, std::uint64_t known_generation,
                      std::uint64_t generation) {
    is_busy_ = true;
    auto look = [exchange = exchange_, profile = profile_, segment = std::move(segment), known_generation,
                 generation] {
        exchange->outcome = look_at(*segment, known_generation, generation, *profile);
        exchange->has_outcome.store(true);
    };
    if (thread_ == nullptr) return look();
    is_busy_ = thread_->do_later(std::move(look));
}

std::optional<JobLoader::Outcome> JobLoader::take_outcome() {
    if (!exchange_->has_outcome.exchange(false)) return std::nullopt;
    is_busy_ = false;
    return std::exchange(exchange_->outcome, Outcome{});
}

}  // namespace psicarve::supervisor
