// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "hmi/verify/carved_surface.hpp"
#include "hmi/verify/trace_reader.hpp"
#include "hmi/verify/verify_report.hpp"
#include "shared/job.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"

namespace psicarve::verify {

/// Judges a pin trace against a job, event by event, so that it can run beside the core that writes the
/// trace. Knows the job, the profile and the pins; nothing of what made them.
///
/// Call order: begin, feed (any number of times), finish. One thread. The job's blob outlives the verifier.
class Verifier {
public:
    /// Refuses jobs that cannot be judged: no points, no layers, a sweep or a scale of nothing.
    static Result<Verifier> make(const JobView& job, const Profile& profile);

    Verifier(Verifier&&) noexcept;
    Verifier& operator=(Verifier&&) noexcept;
    ~Verifier();

    void begin(const TraceStart& start);
    void feed(std::span<const TraceEvent> events);
    VerifyReport finish();

    /// The piece as it came out of the pins so far.
    const CarvedSurface& surface() const noexcept;

private:
    struct State;
    explicit Verifier(std::unique_ptr<State> state) noexcept;
    std::unique_ptr<State> state_;
};

/// The whole of a trace through a verifier (`psicarve verify`). The verifier is kept for its surface.
Result<VerifyReport> verify_trace(Verifier& verifier, TraceReader& trace);

}  // namespace psicarve::verify
