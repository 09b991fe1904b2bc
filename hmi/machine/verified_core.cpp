// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/verified_core.hpp"

#include <chrono>
#include <span>
#include <utility>

namespace psicarve::machine {
namespace {

using Clock = std::chrono::steady_clock;

/// A verification that reads nothing for this long is given up.
constexpr std::chrono::seconds kStandstill{10};

}  // namespace

Result<VerifiedCore> VerifiedCore::start(CoreLaunch launch, const JobView& job, const Profile& profile,
                                         verify::Verifier::Follower follower,
                                         const verify::AskedCarving& asked) {
    const std::string toml = profile_to_toml(profile);
    const auto profile_file = open_memory_file("profile", std::as_bytes(std::span{toml}));
    if (!profile_file) return profile_file.error();
    auto pipe = open_pipe();
    if (!pipe) return pipe.error();
    // The child sees both under the same numbers.
    launch.profile_path = "/proc/self/fd/" + std::to_string(profile_file->get());
    launch.trace_paths.push_back("fd:" + std::to_string(pipe->write_end.get()));
    launch.inherited_fds.insert(launch.inherited_fds.end(), {profile_file->get(), pipe->write_end.get()});
    auto core = CoreProcess::start(launch);
    if (!core) return core.error();
    pipe->write_end.reset();
    auto link = MachineLink::attach(launch.segment_name, launch.group);
    if (!link) return link.error();
    auto verification =
        PipeVerification::start(job, profile, std::move(pipe->read_end), std::move(follower), asked);
    if (!verification) return verification.error();
    return VerifiedCore{std::move(verification).value(), std::move(core).value(), std::move(link).value()};
}

Result<verify::VerifyReport> VerifiedCore::finish(const std::function<void()>& meanwhile) {
    std::uint64_t seen = verification_->progress();
    auto last_progress = Clock::now();
    // On a busy computer the core may be waiting for us.
    (void)core_.end_while([&] {
        meanwhile();
        const std::uint64_t before = std::exchange(seen, verification_->progress());
        const auto now = Clock::now();
        if (seen != before) last_progress = now;
        return now - last_progress < kStandstill;
    });
    core_.end();
    return verification_->finish();
}

}  // namespace psicarve::machine
