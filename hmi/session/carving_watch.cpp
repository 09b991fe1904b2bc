// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/carving_watch.hpp"

#include <algorithm>
#include <utility>

namespace psicarve::session {
namespace {

constexpr std::uint64_t kCellsPerLook = 100'000;  // some milliseconds

struct Blank {
    std::unique_ptr<CarvingRecord> record;
    std::unique_ptr<LivePiece> piece;
};

}  // namespace

/// A fresh blank for a large job takes longer than a window may stand still, and so does freeing the old one;
/// increments meanwhile wait in the core's ring.
void CarvingWatch::make_blank() {
    std::shared_ptr<const CarvingRecord> record_before{std::move(record_)};
    std::shared_ptr<const LivePiece> piece_before{std::move(piece_)};
    is_doubt_told_ = false;
    queue_.drop_waiting();
    queue_.post([this, record_before = std::move(record_before), piece_before = std::move(piece_before),
                 job = job_, number = ++blank_number_]() mutable -> BackgroundQueue::Finish {
        piece_before.reset();
        record_before.reset();
        if (!job) return {};
        auto made = CarvingRecord::make(job);
        if (!made) return {};
        const auto blank = std::make_shared<Blank>();
        blank->record = std::move(*made);
        if (job->profile.tool.shape != ToolShape::point)
            blank->piece = std::make_unique<LivePiece>(job, blank->record->geometry());
        return [this, number, blank] {
            if (number != blank_number_) return;
            record_ = std::move(blank->record);
            piece_ = std::move(blank->piece);
            ++edition_;
        };
    });
}

void CarvingWatch::refresh() {
    queue_.deliver();
    const auto job = desk_.core_job();
    // The piece of a core that has ended stays visible.
    if (job != job_ && (job || machine_.view().is_heard())) {
        job_ = job;
        job_start_tick_ = 0;
        doubt_.forget();
        make_blank();
    }
    const auto& status = machine_.view().status;
    if (!job_ || !status) return machine_.skip_increments();
    // A dry run carves nothing, a program another piece: this one stays as it is.
    if (status->is_dry != 0 || machine_.view().runs_program()) {
        ran_job_ = false;
        machine_.skip_increments();
        lost_ = machine_.lost_increments();
        return;
    }
    if (status->job_start_tick != job_start_tick_) {
        if (job_start_tick_ != 0) make_blank();
        job_start_tick_ = status->job_start_tick;
        layers_carved_ = layers_carved(*status);
    }
    if (!record_) return;
    take_doubt(*status);
    take_increments(*status);
    const bool is_complete = status->points_total > 0 && status->points_done == status->points_total;
    if (status->points_done > 0)
        record_->take_as_planned(is_complete ? status->layer + 1 : status->layer, kCellsPerLook);
}

std::uint32_t CarvingWatch::layers_carved(const CoreStatus& status) const noexcept {
    const std::uint64_t layers = status.points_done / job_->view.point_count();
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(layers, job_->view.layer_count()));
}

/// What was carved since the last look, before the alarms: theirs were carved before them.
void CarvingWatch::take_doubt(const CoreStatus& status) {
    const std::uint32_t before = std::exchange(layers_carved_, layers_carved(status));
    const bool are_fewer = doubt_.carved_again(before, layers_carved_);
    if (doubt_.take(status) || are_fewer) is_doubt_told_ = false;
    if (!std::exchange(is_doubt_told_, true)) record_->set_doubt(doubt_.layers());
}

void CarvingWatch::take_increments(const CoreStatus& status) {
    // A jogged head cuts nothing, its spindle stands still; the increments do not show that.
    const bool runs = machine_.view().runs_job();
    const bool was_at_job = runs || ran_job_;
    ran_job_ = runs;
    // Increments before this start belong to another piece.
    machine_.read_increments([&](const IncrementEntry& entry) {
        if (job_start_tick_ == 0 || entry.tick < job_start_tick_) return;
        const bool is_of_job = status.job_end_tick != 0 ? entry.tick <= status.job_end_tick : was_at_job;
        if (!is_of_job) return;
        record_->take(entry);
        if (piece_) piece_->take(entry);
    });
    const std::uint64_t lost = machine_.lost_increments();
    const bool has_lost = std::exchange(lost_, lost) != lost;
    if (piece_ && job_start_tick_ != 0) piece_->look({status.points_done, has_lost});
}

}  // namespace psicarve::session
