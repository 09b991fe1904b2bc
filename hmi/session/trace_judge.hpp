// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/verify/verifier.hpp"

namespace psicarve::session {

/// The verification of a trace against its job.
struct Judgement {
    std::string path;
    std::shared_ptr<const cam::PreparedJob> job;
    verify::VerifyReport report;
    std::shared_ptr<const verify::Verifier> verifier;  ///< for its carved surface
};

/// Judges a pin trace against a job, as `psicarve verify` does, on a thread of its own. All calls come from
/// one thread, the owner's.
class TraceJudge {
public:
    explicit TraceJudge(MessageLog& log) : log_(log) {}
    ~TraceJudge() { cancel(); }

    /// Uses the job that the trace carries; `job`, which may be null, is for a trace that carries none.
    /// `asked`: what of that job was to be carved.
    void judge(const std::string& path, std::shared_ptr<const cam::PreparedJob> job,
               const verify::AskedCarving& asked = {});
    void cancel() noexcept { cancels_.store(true); }
    bool is_judging() const noexcept { return is_judging_; }
    /// Call it at screen rate.
    void poll() { queue_.deliver(); }
    /// The result of the last judgement, once.
    std::shared_ptr<const Judgement> take() noexcept { return std::move(done_); }

private:
    MessageLog& log_;
    bool is_judging_ = false;
    std::atomic<bool> cancels_{false};
    std::shared_ptr<const Judgement> done_;
    BackgroundQueue queue_{BackgroundQueue::Haste::background};  // last: its thread uses the others
};

struct VerdictRow {
    Phrase name;
    Phrase value;
};
/// That it is verified, and how far; for reports that are.
Phrase verified_phrase(const verify::VerifyReport& report);

std::vector<VerdictRow> verdict_rows(const verify::VerifyReport& report);

}  // namespace psicarve::session
