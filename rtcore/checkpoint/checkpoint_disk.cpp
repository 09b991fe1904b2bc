// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/checkpoint/checkpoint_disk.hpp"

#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "rtcore/process/state_folder.hpp"
#include "rtcore/process/words.hpp"
#include "shared/file/withdrawn_file.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::supervisor {
namespace {

std::string megabytes(std::uint64_t bytes) {
    return std::to_string(bytes >> 20) + " MiB";
}

Result<void> check_room_for(std::uint64_t job_bytes, const std::string& folder) {
    if (job_bytes > kMostCopiedBytes) {
        return Error{ErrorCode::out_of_room,
                     folder + ": a job of " + megabytes(job_bytes) + " is too large to be copied there"};
    }
    struct statvfs disk {};
    if (::statvfs(folder.c_str(), &disk) != 0) return {};  // the write reports the fault
    const std::uint64_t free_bytes = std::uint64_t{disk.f_bavail} * disk.f_frsize;
    if (free_bytes / 2 >= job_bytes) return {};
    return Error{ErrorCode::out_of_room, folder + ": a job of " + megabytes(job_bytes) +
                                             " is not copied there, with " + megabytes(free_bytes) + " free"};
}

/// A number that no earlier record had, also where all traces of those are gone.
std::uint64_t first_sequence() {
    using std::chrono::system_clock;
    return static_cast<std::uint64_t>(system_clock::now().time_since_epoch() / std::chrono::nanoseconds{1});
}

}  // namespace

LeftCheckpoint CheckpointDisk::read_left() noexcept {
    try {
        sequence_ = first_sequence();
        LeftCheckpoint left = look();
        if (left.is_unknown) is_unread_ = true;
        return left;
    } catch (const std::exception& problem) {
        rtcore::try_to_say(problem.what());
        is_unread_ = true;
        return {std::nullopt, true};
    }
}

LeftCheckpoint CheckpointDisk::look() {
    const std::string path = names_.checkpoint();
    auto left = load_saved_checkpoint(path);
    if (!left) {
        std::error_code error;
        // A folder whose files cannot be seen may have the record as well.
        if (!std::filesystem::exists(path, error) && !error) return {};
        if (!std::exchange(has_told_unread_, true))
            rtcore::try_to_say(left.error().message + ": nothing is known of an unfinished piece");
        return {std::nullopt, true};
    }
    if (!left->is_of(place_.segment_name, place_.is_simulator)) {
        if (!std::exchange(has_told_unread_, true))
            rtcore::try_to_say(path + ": is of segment " + left->segment_name +
                               (left->is_simulator ? ", a simulated machine's" : "") + ": it is not taken");
        return {};
    }
    note_standing(*left);
    sequence_ = std::max(sequence_, left->sequence);
    return {std::move(*left), false};
}

/// The record of this state: the job's facts are the same for all its layers.
SavedCheckpoint CheckpointDisk::saved_of(const KeptState& state) {
    if (facts_.checkpoint.job_checksum != state.job->checksum) {
        const auto profile = job_profile(state.job->view);
        facts_.job_bytes = state.job->blob.size();
        facts_.profile_hash = place_.profile_hash;
        facts_.is_simulator = place_.is_simulator;
        facts_.segment_name = place_.segment_name;
        facts_.source_name = std::string{state.job->view.source_name()};
        facts_.tool = profile ? tool_text(profile->tool) : std::string{};
        facts_.checkpoint.job_checksum = state.job->checksum;
    }
    SavedCheckpoint saved = facts_;
    saved.checkpoint = state.checkpoint;
    saved.written_s = state.written_s;
    return saved;
}

/// It is safe to continue from a lower layer of the present piece, and from the layer of the run before it
/// once this one came as far. It is not safe from a higher layer, nor with a piece that is no longer on the
/// table, or is carved to its end.
bool CheckpointDisk::may_stay(const Checkpoint& now) const noexcept {
    if (is_unread_ || now.next_layer == now.layer_count) return false;
    return std::ranges::all_of(may_stand_, [&](const Checkpoint& standing) {
        return standing.job_checksum == now.job_checksum && standing.next_layer <= now.next_layer &&
               (standing.earlier_layer == now.earlier_layer || standing.earlier_layer <= now.next_layer);
    });
}

bool CheckpointDisk::tells_of(std::uint64_t job_checksum) const noexcept {
    return is_unread_ || std::ranges::any_of(may_stand_, [&](const Checkpoint& standing) {
               return standing.job_checksum == job_checksum;
           });
}

void CheckpointDisk::note_standing(const SavedCheckpoint& saved) {
    standing_ = saved;
    may_stand_.assign(1, saved.checkpoint);
    is_unread_ = false;
    standing_sequence.store(saved.sequence);
    standing_job.store(saved.checkpoint.job_checksum);
}

void CheckpointDisk::note_gone() {
    standing_.reset();
    may_stand_.clear();
    is_unread_ = false;
    standing_job.store(0);
    standing_sequence.store(0);
}

void CheckpointDisk::do_given() {
    is_asked_for.store(false);
    const std::uint64_t seen = given_order.load();
    // In this order: layers carved before a waiting run are taken with it, or were before.
    auto run = runs.take();
    const auto newest = carved.take();
    if (newest != nullptr && run != nullptr && newest->order > run->order) run.reset();
    if (newest != nullptr) write(*newest);
    if (run != nullptr) write(*run);
    if (const auto named = forgets.take(); named != nullptr)
        for (const RecordName& record : *named) forget(record);
    done_order.store(seen);
}

void CheckpointDisk::write(const KeptState& state) {
    order_ = state.order;
    // A disk that could not be read then may be readable now.
    if (is_unread_) look();
    if (state.why == Keeping::as_before) return take_back(state);
    SavedCheckpoint wanted = saved_of(state);
    if (state.why == Keeping::announced) {
        Checkpoint& announced = wanted.checkpoint;
        // A record of another job stays true.
        if (announced.earlier_layer == 0 && !tells_of(announced.job_checksum)) return;
        if (!std::exchange(is_announced_, true)) stood_ = standing_;
        const bool is_of_it = stood_ && stood_->checkpoint.job_checksum == announced.job_checksum;
        if (is_of_it && announced.next_layer == 0 && announced.earlier_layer == 0)
            announced = checkpoint_at(announced.job_checksum, 0, announced.layer_count,
                                      stood_->checkpoint.left_behind(), announced.origin);
    } else {
        is_announced_ = false;
        stood_.reset();
    }
    put(wanted);
}

/// Nothing was carved. The segment's record of the job may be newer than the one on the disk: that may not
/// have been written.
void CheckpointDisk::take_back(const KeptState& state) {
    const bool was_announced = std::exchange(is_announced_, false);
    const auto stood = was_announced ? std::exchange(stood_, std::nullopt) : standing_;
    const Checkpoint& known = state.checkpoint;
    const bool is_known = is_checkpoint(known);
    const bool is_of_it = stood && is_known && stood->checkpoint.job_checksum == known.job_checksum;
    const bool is_same = is_of_it && stood->checkpoint.next_layer == known.next_layer &&
                         stood->checkpoint.earlier_layer == known.earlier_layer;
    if (is_known && !is_same && (is_of_it || !stood)) return put(saved_of(state));
    if (was_announced && stood) put(*stood);
}

void CheckpointDisk::put(const SavedCheckpoint& saved) {
    SavedCheckpoint numbered = saved;
    numbered.sequence = ++sequence_;
    tried_order.store(order_);
    tried_sequence.store(sequence_);
    auto done = make_state_folder(place_.folder);
    if (done) done = save_checkpoint(numbered, names_.checkpoint());
    if (!done) return mend(numbered, done.error());
    note_standing(numbered);
    has_failed_ = false;
    has_lied_ = false;
    is_refused.store(false);
}

/// The record could not be written, or not for certain: decides whether the one on the disk may stay, or must
/// go.
void CheckpointDisk::mend(const SavedCheckpoint& wanted, const Error& why) {
    is_refused.store(true);
    const Checkpoint& now = wanted.checkpoint;
    if (!may_stay(now)) {
        if (const auto gone = withdraw_file(names_.checkpoint()); gone) {
            note_gone();
        } else if (!std::exchange(has_lied_, true)) {
            has_failed_ = true;
            return rtcore::try_to_say(
                why.message + "; " + gone.error().message +
                "; what it tells is not of the piece that is being carved: if the computer is switched "
                "off, do not go on by it");
        }
    } else {
        // It may stand there all the same, without its folder's sync. Those between are lower.
        const bool is_of_last = may_stand_.size() > 1 && may_stand_.back().earlier_layer == now.earlier_layer;
        if (is_of_last) may_stand_.pop_back();
        may_stand_.push_back(now);
    }
    if (!std::exchange(has_failed_, true)) {
        rtcore::try_to_say(why.message +
                           "; if the computer is switched off, nobody knows how far the piece has come");
    }
}

void CheckpointDisk::forget(const RecordName& record) {
    if (const auto gone = withdraw_record(names_.checkpoint(), record); !gone) {
        if (!std::exchange(has_told_unforgotten_, true))
            rtcore::try_to_say(gone.error().message + ": the piece is not forgotten");
        return;
    }
    has_told_unforgotten_ = false;
    if (standing_ && standing_->name() == record) note_gone();
    if (stood_ && stood_->name() == record) stood_.reset();
    ::unlink(names_.job(record.job_checksum).c_str());
}

void CheckpointDisk::copy_newest() {
    const auto job = jobs.take();
    if (job == nullptr) return;
    const std::uint64_t checksum = (*job)->checksum;
    const auto copied = copy(**job);
    const std::uint64_t failed_before = uncopied_job.exchange(copied ? 0 : checksum);
    // Report it once for each job: the copy is tried again.
    if (!copied && failed_before != checksum) {
        rtcore::try_to_say(copied.error().message +
                           "; after the computer was switched off publish it from its own file");
    }
    remove_other_jobs(names_.job(checksum));
}

Result<void> CheckpointDisk::copy(const LoadedJob& job) const {
    const std::string path = names_.job(job.checksum);
    // A file with this name is complete: it gets its name last.
    if (is_snapshot_file(path)) return {};
    if (const auto made = make_state_folder(place_.folder); !made) return made.error();
    if (const auto room = check_room_for(job.blob.size(), place_.folder); !room) return room.error();
    return save_job_for_everybody(job.blob, path);
}

/// Removes them as far as the folder can be read.
void CheckpointDisk::remove_other_jobs(const std::string& path) const {
    std::error_code error;
    std::vector<std::string> others;
    // Not by a range loop: that throws where the disk fails.
    for (std::filesystem::directory_iterator entry{place_.folder, error}, end; !error && entry != end;
         entry.increment(error)) {
        const std::string other = place_.folder + "/" + entry->path().filename().string();
        if (other != path && names_.is_job(other)) others.push_back(other);
    }
    for (const std::string& other : others) ::unlink(other.c_str());
}

}  // namespace psicarve::supervisor
