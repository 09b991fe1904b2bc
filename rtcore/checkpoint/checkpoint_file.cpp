// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/checkpoint/checkpoint_file.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "rtcore/process/words.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::seconds kReadingPatience{2};
constexpr std::chrono::seconds kWritingPatience{2};
constexpr std::chrono::seconds kPauseBeforeNextTry{2};
constexpr std::size_t kMostForgets = 16;

std::int64_t seconds_now() {
    using std::chrono::system_clock;
    return std::chrono::duration_cast<std::chrono::seconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

CheckpointFile::CheckpointFile(CheckpointPlace place)
    : place_(CoreKeeping::in(place.folder)), folder_(place.folder) {
    if (place.folder.empty()) return;
    disk_ = std::make_shared<CheckpointDisk>(std::move(place));
    checkpoints_ = std::make_unique<rtcore::SideThread>();
    jobs_ = std::make_unique<rtcore::SideThread>();
    auto left = std::make_shared<std::promise<LeftCheckpoint>>();
    reading_ = left->get_future();
    checkpoints_->do_later([disk = disk_, left] { left->set_value(disk->read_left()); });
    is_late_ = reading_.wait_for(kReadingPatience) != std::future_status::ready;
    look_at_left();
}

void CheckpointFile::look_at_left() {
    if (!reading_.valid() || reading_.wait_for(std::chrono::seconds{0}) != std::future_status::ready) return;
    LeftCheckpoint left = reading_.get();
    is_left_unknown_ = left.is_unknown;
    if (!left.saved) return;
    std::uint32_t& told = told_[left.saved->checkpoint.job_checksum];
    told = std::max(told, left.saved->checkpoint.next_layer);
    if (!is_left_past_ && !is_forgotten(left.saved->name())) left_ = std::move(left.saved);
    forgotten_.clear();
}

bool CheckpointFile::is_forgotten(const RecordName& left) const noexcept {
    return std::ranges::any_of(forgotten_, [&](const RecordName& record) {
        return record == left || (record.sequence == 0 && record.job_checksum == left.job_checksum);
    });
}

bool CheckpointFile::has_answered_late() {
    look_at_left();
    return !reading_.valid() && std::exchange(is_late_, false);
}

CoreKeeping CheckpointFile::keeping() const noexcept {
    if (disk_ == nullptr) return place_;
    const bool is_refused = reading_.valid() || is_silent_ || disk_->is_refused.load();
    return {is_refused ? CoreKeeping::How::refused : CoreKeeping::How::kept, place_.folder_mark};
}

void CheckpointFile::keep(const ToKeep& what, const std::shared_ptr<const LoadedJob>& job) {
    if (disk_ == nullptr) return;
    look_at_left();
    std::uint32_t& told = told_[job->checksum];
    told = std::max(told, what.checkpoint.next_layer);
    auto& place = what.why == Keeping::carved ? disk_->carved : disk_->runs;
    // A run that carves needs no announcement any more.
    if (what.why == Keeping::carved) disk_->runs.take();
    const CheckpointDisk::KeptState state{what.checkpoint, job, seconds_now(), what.why, ++given_};
    place.put(state);
    ask();
    last_carved_.reset();
    if (what.why != Keeping::carved) return;
    last_carved_ = state;
    next_try_ = std::chrono::steady_clock::now() + kPauseBeforeNextTry;
    carved_job_ = job->checksum;
    carved_order_ = given_;
    left_.reset();
    is_left_past_ = true;
    copy(job);
}

/// Keeps at most one task waiting for the disk, however much is given meanwhile.
void CheckpointFile::ask() {
    disk_->given_order.store(given_);
    if (disk_->is_asked_for.exchange(true)) return;
    must_ask_ = !checkpoints_->do_later([disk = disk_] { disk->do_given(); });
    if (must_ask_) disk_->is_asked_for.store(false);
}

void CheckpointFile::tend() {
    if (disk_ == nullptr) return;
    if (must_ask_) ask();
    const std::uint64_t done = disk_->done_order.load();
    if (done == given_) {
        waiting_since_.reset();
        is_silent_ = false;
        has_said_silent_ = false;
        return try_again();
    }
    const auto now = std::chrono::steady_clock::now();
    if (!waiting_since_ || std::exchange(done_seen_, done) != done) {
        waiting_since_ = now;
        done_seen_ = done;
        is_silent_ = false;
        return;
    }
    is_silent_ = now - *waiting_since_ >= kWritingPatience;
    if (is_silent_ && !std::exchange(has_said_silent_, true)) {
        rtcore::try_to_say(folder_ +
                           ": the disk does not answer; if the computer is switched off now, do not go on by "
                           "what it tells of an unfinished piece");
    }
}

/// Writes again what a disk has refused: it may take it now, though nothing more is carved.
void CheckpointFile::try_again() {
    if (!disk_->is_refused.load()) last_carved_.reset();
    if (!last_carved_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_try_) return;
    next_try_ = now + kPauseBeforeNextTry;
    last_carved_->order = ++given_;
    carved_order_ = given_;
    disk_->carved.put(*last_carved_);
    ask();
}

void CheckpointFile::copy(const std::shared_ptr<const LoadedJob>& job) {
    if (copied_job_ != job->checksum) {
        copied_job_ = job->checksum;
        copy_pause_layers_ = 1;
        layers_to_next_copy_ = 1;
    } else {
        if (disk_->uncopied_job.load() != job->checksum || --layers_to_next_copy_ != 0) return;
        copy_pause_layers_ *= 2;
        layers_to_next_copy_ = copy_pause_layers_;
    }
    if (disk_->jobs.put(job)) jobs_->do_later([disk = disk_] { disk->copy_newest(); });
}

std::optional<SavedCheckpoint> CheckpointFile::left_of(const LoadedJob& job) {
    look_at_left();
    const bool is_of_it = left_ && left_->checkpoint.job_checksum == job.checksum &&
                          left_->checkpoint.layer_count == job.view.layer_count() &&
                          left_->job_bytes == job.blob.size();
    return is_of_it ? left_ : std::nullopt;
}

std::uint32_t CheckpointFile::most_told_of(const LoadedJob& job) {
    if (disk_ == nullptr) return 0;
    look_at_left();
    // A disk that has not been read yet may hold any record.
    if (reading_.valid() || is_left_unknown_) return job.view.layer_count();
    const auto told = told_.find(job.checksum);
    return told == told_.end() ? 0 : told->second;
}

bool CheckpointFile::is_newest(const RecordName& record) const noexcept {
    if (disk_ == nullptr) return true;
    const bool is_carved_now = carved_job_ == record.job_checksum;
    const auto holds_newest = [&](std::uint64_t order) { return !is_carved_now || order >= carved_order_; };
    const bool is_done = holds_newest(disk_->done_order.load());
    if (record.sequence == 0) return is_done && disk_->standing_job.load() != record.job_checksum;
    if (record.sequence == disk_->standing_sequence.load() && is_done) return true;
    return record.sequence == disk_->tried_sequence.load() && holds_newest(disk_->tried_order.load());
}

bool CheckpointFile::forget(const RecordName& record) {
    if (disk_ == nullptr) return true;
    look_at_left();
    auto waiting = disk_->forgets.take();
    if (waiting == nullptr) waiting = std::make_unique<std::vector<RecordName>>();
    const bool is_new = std::ranges::find(*waiting, record) == waiting->end();
    const bool is_full = is_new && waiting->size() >= kMostForgets;
    if (is_new && !is_full) waiting->push_back(record);
    // Behind the writes that wait: their records have other sequences.
    disk_->forgets.put(std::move(*waiting));
    ++given_;
    ask();
    if (is_full) return false;
    if (reading_.valid() && is_new) forgotten_.push_back(record);
    if (last_carved_ && last_carved_->job->checksum == record.job_checksum) last_carved_.reset();
    if (left_ && left_->name() == record) left_.reset();
    if (copied_job_ == record.job_checksum) copied_job_ = 0;  // its copy is removed, too
    return true;
}

}  // namespace psicarve::supervisor
