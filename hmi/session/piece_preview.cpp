// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/piece_preview.hpp"

#include <algorithm>
#include <numeric>
#include <thread>
#include <tuple>
#include <utility>

#include "hmi/cam/job_plan.hpp"
#include "hmi/phrase/error_phrase.hpp"
#include "hmi/piece/draft_piece.hpp"

namespace psicarve::session {
namespace {

constexpr std::size_t kPieceColumns = 720;

double pulse_of(const Profile& profile) {
    return 1.0 / profile.r1.pulses_per_mm;
}

Result<PieceView> piece_of_job(const PieceRequest& request, const PieceScenePlan& plan,
                               const slice::SliceOptions& options) {
    const cam::PreparedJob& job = *request.job;
    std::optional<piece::PlacedModel> placed;
    if (request.mesh) {
        auto found = piece::place_as_sliced(request.mesh, job.view, job.profile);
        if (!found) return found.error();
        placed = std::move(*found);
    }
    const auto piece =
        piece::job_piece(job.view, job.profile, placed ? &*placed : nullptr, kPieceColumns, options);
    if (!piece) return piece.error();
    return look_at_piece(*piece, pulse_of(job.profile), plan);
}

Result<PieceView> piece_of_draft(const PieceRequest& request, const PieceScenePlan& plan,
                                 const slice::SliceOptions& options) {
    cam::JobOptions placing = request.options;
    placing.search_progress = [&options](double) { return !options.progress || options.progress(0.0); };
    cam::SliceReport report;
    const auto planned = cam::plan_job(*request.mesh, request.profile, placing, report);
    if (!planned) return planned.error();
    const piece::PlacedModel model{request.mesh, planned->placement, planned->scale,
                                   request.profile.job.base_height_mm, request.profile.core_radius_mm};
    auto draft = piece::draft_piece(model, request.profile, options);
    if (!draft) return draft.error();
    piece::JobPiece piece{std::move(draft->piece), {}, std::move(draft->deviation)};
    piece.rows.resize(piece.piece.row_count());
    std::iota(piece.rows.begin(), piece.rows.end(), std::size_t{0});
    PieceView piece_view = look_at_piece(piece, pulse_of(request.profile), plan);
    piece_view.draft_allowance_mm = draft->allowance_mm;
    return piece_view;
}

}  // namespace

bool operator==(const PieceRequest& a, const PieceRequest& b) {
    if (a.job != b.job || a.mesh != b.mesh) return false;
    if (a.job) return true;
    const auto placing = [](const cam::JobOptions& o) {
        return std::tuple{o.up, o.axis_at, o.axis_x, o.axis_y, o.height_mm, o.scale, o.fits};
    };
    return a.profile == b.profile && placing(a.options) == placing(b.options);
}

Result<PieceView> work_out_piece(const PieceRequest& request, const PieceScenePlan& plan,
                                 const slice::SliceOptions& options) {
    return request.job ? piece_of_job(request, plan, options) : piece_of_draft(request, plan, options);
}

void PiecePreview::stop() {
    if (run_) run_->goes_on.store(false);
    run_.reset();
    queue_.drop_waiting();
}

void PiecePreview::cancel() {
    if (!run_) return;
    stop();
    problem_ = phrase("Working the piece out was cancelled");
}

void PiecePreview::poll(const std::optional<PieceRequest>& request, const PieceScenePlan& plan,
                        bool is_asked_for) {
    queue_.deliver();
    if (request != wish_) {
        stop();
        wish_ = request;
        view_.reset();
        problem_ = {};
    }
    if (!is_asked_for) {
        stop();
        problem_ = {};
    } else if (wish_ && !view_ && !run_ && problem_.is_empty()) {
        begin(plan);
    }
}

void PiecePreview::begin(const PieceScenePlan& plan) {
    run_ = std::make_shared<Run>();
    queue_.post([this, request = *wish_, plan, run = run_]() -> BackgroundQueue::Finish {
        // One processor is left for the window, and for a core on the same computer.
        const slice::SliceOptions options{std::max(1U, std::thread::hardware_concurrency() / 2),
                                          [&run](double done) {
                                              run->done_ratio.store(done);
                                              return run->goes_on.load();
                                          }};
        auto worked_out = work_out_piece(request, plan, options);
        const auto piece_view =
            worked_out ? std::make_shared<const PieceView>(std::move(*worked_out)) : nullptr;
        const Phrase problem = worked_out ? Phrase{} : error_phrase(worked_out.error());
        return [this, run, piece_view, problem] {
            if (!run->goes_on.load()) return;
            run_.reset();
            view_ = piece_view;
            problem_ = problem;
        };
    });
}

}  // namespace psicarve::session
