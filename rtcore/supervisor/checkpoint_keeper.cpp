// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/checkpoint_keeper.hpp"

#include <algorithm>
#include <utility>

#include "shared/machine_state.hpp"
#include "shared/shared_record.hpp"

namespace psicarve::supervisor {
namespace {

/// What the segment knows of this very job.
std::optional<Checkpoint> known_of(const SegmentHeader& header, const LoadedJob& job) noexcept {
    const auto known = read_record(header.checkpoint);
    const bool is_known = known && is_checkpoint(*known) && known->job_checksum == job.checksum &&
                          known->layer_count == job.view.layer_count();
    return is_known ? known : std::nullopt;
}

/// Layers of the piece that a run of the whole job leaves behind: of the run before, and not of whichever
/// came furthest; where that has finished none, of the one before it.
std::uint32_t left_behind(const Checkpoint& before) noexcept {
    if (before.next_layer == before.layer_count) return 0;
    return before.next_layer != 0 ? before.next_layer : before.earlier_layer;
}

}  // namespace

std::optional<Checkpoint> CheckpointKeeper::note(SegmentHeader& header, const cycle::Sample& sample,
                                                 const LoadedJob* job) noexcept {
    if (job == nullptr) return std::nullopt;
    if (!is_carving_of(sample, *job)) return announce(header, sample, *job);
    is_announced_ = false;
    if (begun_tick_ != run_start_tick_) begin_run(header, sample.first_layer, *job);
    if (leaves_gap_) return std::nullopt;
    const std::uint64_t layers_done =
        std::max<std::uint64_t>(carved_before_, sample.points_done / job->view.point_count());
    const auto next_layer =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(layers_done, job->view.layer_count()));
    const std::uint32_t earlier = earlier_layer_ > next_layer ? earlier_layer_ : 0;
    if (written_job_ == job->generation && written_ && written_->next_layer == next_layer &&
        written_->earlier_layer == earlier)
        return std::nullopt;
    written_ = checkpoint_at(job->checksum, next_layer, job->view.layer_count(), earlier);
    written_job_ = job->generation;
    write_record(header.checkpoint, *written_);
    return written_;
}

std::optional<Checkpoint> CheckpointKeeper::announce(const SegmentHeader& header, const cycle::Sample& sample,
                                                     const LoadedJob& job) noexcept {
    const bool is_under_way = sample.job_generation == job.generation && runs_job(sample.state);
    // Nothing was carved: all is as it was.
    if (!is_under_way) return std::exchange(is_announced_, false) ? known_of(header, job) : std::nullopt;
    if (is_announced_ || sample.first_layer != 0 || sample.is_dry != 0) return std::nullopt;
    const auto before = known_of(header, job);
    if (!before) return std::nullopt;
    is_announced_ = true;
    return checkpoint_at(job.checksum, 0, job.view.layer_count(), left_behind(*before));
}

void CheckpointKeeper::take_over(SegmentHeader& header, const Checkpoint& left) noexcept {
    const auto before = read_record(header.checkpoint);
    if (!before || !is_checkpoint(*before)) write_record(header.checkpoint, left);
}

void CheckpointKeeper::begin_run(const SegmentHeader& header, std::uint64_t first_layer,
                                 const LoadedJob& job) noexcept {
    begun_tick_ = run_start_tick_;
    carved_before_ = 0;
    earlier_layer_ = 0;
    leaves_gap_ = false;
    const auto before = known_of(header, job);
    if (!before) return;  // whoever begins later than with the first knows of the layers before
    if (first_layer == 0) {
        earlier_layer_ = left_behind(*before);
        return;
    }
    if (before->next_layer == 0 && before->earlier_layer == 0) return;
    // Any other layer behind the newer run's leaves a gap in that: nobody said that it is the older piece's.
    const bool goes_back = before->earlier_layer > before->next_layer && first_layer == before->earlier_layer;
    carved_before_ = goes_back ? before->earlier_layer : before->next_layer;
    earlier_layer_ = goes_back ? 0 : before->earlier_layer;
    leaves_gap_ = first_layer > carved_before_;
}

void CheckpointKeeper::write_anew(SegmentHeader& header) const noexcept {
    if (written_) write_record(header.checkpoint, *written_);
}

// Ticks and points of a run stay in the sample after its end, also when the next job is loaded.
bool CheckpointKeeper::is_carving_of(const cycle::Sample& sample, const LoadedJob& job) noexcept {
    if (sample.job_generation != job.generation) return false;
    if (runs_job(sample.state)) {
        run_generation_ = sample.job_generation;
        run_start_tick_ = sample.job_start_tick;
    }
    return run_generation_ == sample.job_generation && run_start_tick_ == sample.job_start_tick &&
           sample.carve_first_tick != 0 && sample.is_dry == 0;
}

}  // namespace psicarve::supervisor
