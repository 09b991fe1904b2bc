// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/checkpoint/checkpoint_keeper.hpp"

#include <algorithm>
#include <utility>

#include "shared/machine/machine_state.hpp"
#include "shared/segment/reached_point.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::supervisor {
namespace {

std::uint32_t origin_of(bool is_simulator) noexcept {
    return is_simulator ? kCheckpointSimulated : 0;
}

/// Of the job, that the segment says are carved without a gap. Requires its record of this job.
std::uint64_t points_known(const SegmentHeader& header, const Checkpoint& known,
                           const JobView& job) noexcept {
    const std::uint64_t finished = std::uint64_t{known.next_layer} * job.point_count();
    const auto point = point_to_resume(header.reached_point.load(), known);
    if (!point || *point >= job.point_count()) return finished;
    // Turned round twice the order is what it was.
    return finished + carved_point(job.joining(), job.point_count(), known.next_layer, *point) + 1;
}

}  // namespace

bool CheckpointKeeper::clear_foreign(SegmentHeader& header) const noexcept {
    const auto found = read_record(header.checkpoint);
    if (!found || !is_checkpoint(*found) || found->is_simulated() == is_simulator_) return false;
    header.reached_point.store(0);
    write_record(header.checkpoint, Checkpoint{});
    return true;
}

/// The segment's record of this very job.
std::optional<Checkpoint> CheckpointKeeper::known_of(const SegmentHeader& header,
                                                     const LoadedJob& job) const noexcept {
    const auto known = read_record(header.checkpoint);
    const bool is_known = known && is_checkpoint(*known) && known->is_simulated() == is_simulator_ &&
                          known->job_checksum == job.checksum && known->layer_count == job.view.layer_count();
    return is_known ? known : std::nullopt;
}

Checkpoint CheckpointKeeper::own(const LoadedJob& job, std::uint32_t next_layer,
                                 std::uint32_t earlier_layer) const noexcept {
    return checkpoint_at(job.checksum, next_layer, job.view.layer_count(), earlier_layer,
                         origin_of(is_simulator_));
}

std::optional<ToKeep> CheckpointKeeper::note(SegmentHeader& header, const cycle::Sample& sample,
                                             const LoadedJob* job, std::uint32_t most_told) noexcept {
    if (job == nullptr) return std::nullopt;
    if (!is_carving_of(sample, *job)) return announce(header, sample, *job, most_told);
    is_announced_ = false;
    if (begun_tick_ != run_start_tick_) begin_run(header, {sample.first_layer, sample.first_step}, *job);
    if (leaves_gap_) return std::nullopt;
    reached_points_ = std::max<std::uint64_t>(reached_points_, sample.points_done);
    const std::uint64_t layers_done =
        std::max<std::uint64_t>(carved_before_, sample.points_done / job->view.point_count());
    const auto next_layer =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(layers_done, job->view.layer_count()));
    const std::uint32_t earlier = earlier_layer_ > next_layer ? earlier_layer_ : 0;
    const bool is_written = written_job_ == job->generation && written_ &&
                            written_->next_layer == next_layer && written_->earlier_layer == earlier;
    if (!is_written) {
        written_ = own(*job, next_layer, earlier);
        written_job_ = job->generation;
        write_record(header.checkpoint, *written_);
    }
    // A process that dies between the two leaves a point that is not of the record's layer, which counts for
    // nothing.
    note_point(header, sample, *job, next_layer);
    return is_written ? std::nullopt : std::optional{ToKeep{*written_, Keeping::carved}};
}

void CheckpointKeeper::note_point(SegmentHeader& header, const cycle::Sample& sample, const LoadedJob& job,
                                  std::uint32_t next_layer) noexcept {
    // From which of a run's points on steps were lost is not known: the layer is proposed.
    has_lost_steps_ = has_lost_steps_ || sample.alarm_cause == AlarmCause::steps_lost;
    const std::uint32_t count = job.view.point_count();
    const std::uint64_t finished = std::uint64_t{next_layer} * count;
    // The first point is the layer's begin; with the last nothing is left of it. An earlier layer that is
    // done again has not come to it.
    const bool is_within =
        !has_lost_steps_ && reached_points_ > finished + 1 && reached_points_ < finished + count;
    if (!is_within) return write_point(header, 0);
    const auto step = static_cast<std::uint32_t>(reached_points_ - finished - 1);
    const std::uint32_t point = carved_point(job.view.joining(), count, next_layer, step);
    write_point(header, reached_word(job.checksum, next_layer, point));
}

// In whatever state it is found out: they may have been lost while the point was reached.
void CheckpointKeeper::note_lost_steps(SegmentHeader& header, const cycle::Sample& sample) noexcept {
    if (sample.alarm_cause != AlarmCause::steps_lost) return;
    has_lost_steps_ = true;
    write_point(header, 0);
}

void CheckpointKeeper::write_point(SegmentHeader& header, std::uint64_t word) noexcept {
    if (std::exchange(written_word_, word) == word) return;
    header.reached_point.store(word);
}

std::optional<ToKeep> CheckpointKeeper::announce(SegmentHeader& header, const cycle::Sample& sample,
                                                 const LoadedJob& job, std::uint32_t most_told) noexcept {
    const bool is_under_way = sample.job_generation == job.generation && runs_job(sample.state);
    const auto before = known_of(header, job);
    if (!is_under_way) {
        // Nothing was carved: the record before is valid.
        if (!std::exchange(is_announced_, false)) return std::nullopt;
        return ToKeep{before ? own(job, before->next_layer, before->earlier_layer) : Checkpoint{},
                      Keeping::as_before};
    }
    if (is_announced_ || sample.is_dry != 0) return std::nullopt;
    const std::uint64_t first_layer = sample.first_layer;
    // A run that begins later continues the known piece, or leaves its record as it is.
    if (before && (first_layer != 0 || sample.first_step != 0)) return std::nullopt;
    if (!before && most_told <= first_layer) return std::nullopt;
    is_announced_ = true;
    // Another blank may be on the table; the way back to the piece before is by its layer.
    if (before) write_point(header, 0);
    if (before) return ToKeep{own(job, 0, before->left_behind()), Keeping::announced};
    const auto first =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(first_layer, job.view.layer_count()));
    return ToKeep{own(job, first, 0), Keeping::announced};
}

CheckpointKeeper::TakenOver CheckpointKeeper::take_over(SegmentHeader& header, const Checkpoint& left,
                                                        const LoadedJob& job) const {
    const auto place = [&] {
        header.reached_point.store(0);
        write_record(header.checkpoint,
                     checkpoint_at(left.job_checksum, left.next_layer, left.layer_count, left.earlier_layer,
                                   origin_of(is_simulator_) | kCheckpointFromDisk));
    };
    const auto before = read_record(header.checkpoint);
    if (before && before->is_empty()) {
        place();
        return {};
    }
    const auto known = known_of(header, job);
    if (!known) return {};
    if (known->next_layer == left.next_layer) return {};
    const Message both = message_of(MessageId::segment_and_disk_disagree, count_argument(known->next_layer),
                                    count_argument(left.next_layer));
    if (left.next_layer > known->next_layer) return {own(job, known->next_layer, known->earlier_layer), both};
    place();
    return {std::nullopt, both};
}

bool CheckpointKeeper::knows(const SegmentHeader& header, const RecordName& record) const noexcept {
    const auto known = read_record(header.checkpoint);
    return known && is_checkpoint(*known) && known->job_checksum == record.job_checksum &&
           known->is_simulated() == record.is_simulator;
}

void CheckpointKeeper::forget(SegmentHeader& header, const RecordName& record) noexcept {
    if (record.is_simulator != is_simulator_) return;
    const auto known = read_record(header.checkpoint);
    if (known && is_checkpoint(*known) && known->job_checksum != record.job_checksum) return;
    if (written_ && written_->job_checksum != record.job_checksum) return;
    write_point(header, 0);
    write_record(header.checkpoint, Checkpoint{});
    written_.reset();
    reached_points_ = 0;
    begun_tick_ = run_start_tick_;
    leaves_gap_ = true;  // the samples of the run that has ended write nothing more
}

void CheckpointKeeper::begin_run(const SegmentHeader& header, const RunBegin& begin,
                                 const LoadedJob& job) noexcept {
    const std::uint64_t first_layer = begin.layer;
    begun_tick_ = run_start_tick_;
    carved_before_ = 0;
    earlier_layer_ = 0;
    has_lost_steps_ = false;
    written_word_.reset();
    const auto before = known_of(header, job);
    const bool is_whole = first_layer == 0 && begin.step == 0;
    reached_points_ = before && !is_whole ? points_known(header, *before, job.view) : 0;
    // An operator who carves a layer again distrusts it: what was reached of it before, and beyond, is past.
    if (begin.step == 0) reached_points_ = std::min(reached_points_, first_layer * job.view.point_count());
    // The operator who begins with a later layer has seen that the earlier ones are carved; within a layer
    // that is not enough.
    leaves_gap_ = !is_known(begin, job);
    if (!before) return;
    if (is_whole) {
        earlier_layer_ = before->left_behind();
        return;
    }
    if (before->next_layer == 0 && before->earlier_layer == 0) return;
    // Any other layer behind the newer run's leaves a gap in that: it need not be the older piece's.
    const bool goes_back = before->earlier_layer > before->next_layer && first_layer == before->earlier_layer;
    carved_before_ = goes_back ? before->earlier_layer : before->next_layer;
    earlier_layer_ = goes_back ? 0 : before->earlier_layer;
    leaves_gap_ = first_layer > carved_before_ || (first_layer == carved_before_ && !is_known(begin, job));
}

/// Whether the piece is carved up to this point of the layer after those that are finished.
bool CheckpointKeeper::is_known(const RunBegin& begin, const LoadedJob& job) const noexcept {
    if (begin.step == 0) return true;
    return begin.layer * job.view.point_count() + begin.step < reached_points_;
}

void CheckpointKeeper::write_anew(SegmentHeader& header) const noexcept {
    if (!written_) return;
    write_record(header.checkpoint, *written_);
    header.reached_point.store(written_word_.value_or(0));
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
