// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "hmi/machine/unique_fd.hpp"
#include "hmi/verify/verifier.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::machine {

/// Verifies a pin trace while a core writes it into a pipe, on a thread of its own: the trace never becomes a
/// file. The core waits on the pipe when the verifier is slower (virtual clock).
class PipeVerification {
public:
    /// The job's blob outlives this. Takes the pipe's read end. The follower is called on that thread.
    static Result<std::unique_ptr<PipeVerification>> start(const JobView& job, const Profile& profile,
                                                           UniqueFd read_end,
                                                           verify::Verifier::Follower follower = {},
                                                           const verify::AskedCarving& asked = {});
    ~PipeVerification();
    PipeVerification(const PipeVerification&) = delete;
    PipeVerification& operator=(const PipeVerification&) = delete;

    /// Waits for the trace's end; every other descriptor of the pipe's write end must be closed. An error
    /// when the trace was cut off: then nothing was verified.
    Result<verify::VerifyReport> finish();
    /// Grows as long as the trace is still read and followed.
    std::uint64_t progress() const noexcept { return progress_.load(std::memory_order_relaxed); }
    /// After finish(): the piece as the pins carved it, as far as they were read.
    const verify::CarvedSurface& surface() const noexcept { return verifier_.surface(); }

private:
    explicit PipeVerification(verify::Verifier verifier) noexcept : verifier_(std::move(verifier)) {}
    void run(UniqueFd read_end);

    verify::Verifier verifier_;
    std::atomic<std::uint64_t> progress_{0};
    std::optional<Result<verify::VerifyReport>> report_;  // written by the thread, read after join
    std::thread thread_;
};

}  // namespace psicarve::machine
