// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "hmi/surface/carved_surface.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "hmi/trace/trace_reader.hpp"
#include "hmi/verify/asked_carving.hpp"
#include "hmi/verify/verify_report.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// Judges a pin trace against a job, event by event, so that it can run beside the core that writes the
/// trace. It knows the job, the profile and the pins, and nothing of the program that made them.
///
/// Call order: begin, feed (any number of times), finish. One thread. The job's blob outlives the verifier.
class Verifier {
public:
    /// Refuses jobs that cannot be judged: no points, no layers, a zero sweep or scale.
    static Result<Verifier> make(const JobView& job, const Profile& profile, const LayerRange& layers = {});
    /// The same for what was asked for: where dry runs alone were, rule 1 is not judged.
    static Result<Verifier> make_for(const JobView& job, const Profile& profile, const AskedCarving& asked);

    Verifier(Verifier&&) noexcept;
    Verifier& operator=(Verifier&&) noexcept;
    ~Verifier();

    Result<void> begin(const TraceStart& start);
    void feed(std::span<const TraceEvent> events);
    VerifyReport finish();

    /// Gets all positions [pulses] and whether the spindle runs, after each instant in which either changed.
    using Follower =
        std::function<void(const std::array<std::int64_t, kAxisCount>& positions, bool spindle_on)>;
    void set_follower(Follower follower);

    /// The piece as the pins have carved it so far.
    const CarvedSurface& surface() const noexcept;

private:
    struct State;
    explicit Verifier(std::unique_ptr<State> state) noexcept;
    std::unique_ptr<State> state_;
};

/// Feeds a whole trace to a verifier (`psicarve verify`). The caller keeps the verifier for its surface.
/// `goes_on` is asked now and then; when it returns false the answer is `cancelled`.
Result<VerifyReport> verify_trace(Verifier& verifier, TraceReader& trace,
                                  const std::function<bool()>& goes_on = {});

}  // namespace psicarve::verify
