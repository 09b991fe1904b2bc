// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hmi/machine/core_process.hpp"
#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/pipe_verification.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::machine {

/// A core of our own on the simulated machine, whose pins are verified while it runs.
class VerifiedCore {
public:
    /// Starts the core that `launch` describes, with the profile, and a trace into our verifier besides those
    /// that `launch` names; `follower` is called until finish(). The job's blob outlives this.
    static Result<VerifiedCore> start(CoreLaunch launch, const JobView& job, const Profile& profile,
                                      verify::Verifier::Follower follower = {},
                                      const verify::AskedCarving& asked = {});

    MachineLink& link() noexcept { return link_; }
    CoreProcess& core() noexcept { return core_; }

    /// Ends the core in order, once its trace is read, however long that takes, and returns the verification;
    /// an error when the trace was cut off. `meanwhile` is called repeatedly while it waits.
    Result<verify::VerifyReport> finish(const std::function<void()>& meanwhile = [] {});
    /// After finish().
    const verify::CarvedSurface& surface() const noexcept { return verification_->surface(); }

private:
    VerifiedCore(std::unique_ptr<PipeVerification> verification, CoreProcess core, MachineLink link) noexcept
        : verification_(std::move(verification)), core_(std::move(core)), link_(std::move(link)) {}

    // In this order: the core ends before the reader of its pipe is waited for.
    std::unique_ptr<PipeVerification> verification_;
    CoreProcess core_;
    MachineLink link_;
};

}  // namespace psicarve::machine
