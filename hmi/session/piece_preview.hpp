// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/prepared_job.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/phrase/phrase.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/piece_view.hpp"

namespace psicarve::session {

/// A request for an expected piece.
struct PieceRequest {
    std::shared_ptr<const cam::PreparedJob> job;  ///< null: a draft is made
    std::shared_ptr<const model::Mesh> mesh;      ///< of the job; null: not known
    Profile profile;                              ///< for a draft
    cam::JobOptions options;                      ///< for a draft: those that place the model

    friend bool operator==(const PieceRequest& a, const PieceRequest& b);
};

/// Calculates the piece that a job, or a tool alone, will leave, on a thread of its own, once it is asked
/// for, and again for another request. All calls come from one thread, the owner's.
class PiecePreview {
public:
    PiecePreview() = default;
    ~PiecePreview() { stop(); }

    /// Call it at screen rate. Another request ends the task under way and drops the result; while
    /// `is_asked_for` is false nothing is begun, and the task under way ends.
    void poll(const std::optional<PieceRequest>& wish, const PieceScenePlan& plan, bool is_asked_for);
    /// Ends the task under way; it begins anew with another request, or once it is asked for again.
    void cancel();
    bool is_working() const noexcept { return run_ != nullptr; }
    double progress_ratio() const noexcept { return run_ ? run_->done_ratio.load() : 0.0; }
    /// For the present request; null until it is there.
    std::shared_ptr<const PieceView> view() const noexcept { return view_; }
    /// Why it will not be there; empty while it may.
    const Phrase& problem() const noexcept { return problem_; }

private:
    struct Run {
        std::atomic<bool> goes_on{true};
        std::atomic<double> done_ratio{0.0};
    };
    void begin(const PieceScenePlan& plan);
    void stop();

    std::optional<PieceRequest> wish_;
    std::shared_ptr<Run> run_;  ///< shared with the task under way
    std::shared_ptr<const PieceView> view_;
    Phrase problem_;
    BackgroundQueue queue_{BackgroundQueue::Haste::background};
};

/// Does the whole calculation on the caller's thread. ErrorCode::cancelled.
Result<PieceView> work_out_piece(const PieceRequest& wish, const PieceScenePlan& plan,
                                 const slice::SliceOptions& options);

}  // namespace psicarve::session
