// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/checkpoint_desk.hpp"

#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "rtcore/supervisor/state_folder.hpp"
#include "rtcore/words.hpp"
#include "shared/snapshot_file.hpp"
#include "shared/withdrawn_file.hpp"

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
    if (::statvfs(folder.c_str(), &disk) != 0) return {};  // writing it will tell
    const std::uint64_t free_bytes = std::uint64_t{disk.f_bavail} * disk.f_frsize;
    if (free_bytes / 2 >= job_bytes) return {};
    return Error{ErrorCode::out_of_room, folder + ": a job of " + megabytes(job_bytes) +
                                             " is not copied there, with " + megabytes(free_bytes) + " free"};
}

/// What no record before had, also where all that told of them is gone.
std::uint64_t first_sequence() {
    using std::chrono::system_clock;
    return static_cast<std::uint64_t>(system_clock::now().time_since_epoch() / std::chrono::nanoseconds{1});
}

}  // namespace

std::optional<SavedCheckpoint> CheckpointDesk::read_left() {
    sequence_ = first_sequence();
    const std::string path = names_.checkpoint();
    auto left = load_saved_checkpoint(path);
    if (!left) {
        std::error_code error;
        if (std::filesystem::exists(path, error))
            rtcore::try_to_say(left.error().message + ": nothing is known of an unfinished piece");
        return std::nullopt;
    }
    if (!left->is_of(place_.segment_name, place_.is_simulator)) {
        rtcore::try_to_say(path + ": is of segment " + left->segment_name +
                           (left->is_simulator ? ", a simulated machine's" : "") + ": it is not taken");
        return std::nullopt;
    }
    written_ = left->checkpoint;
    sequence_ = std::max(sequence_, left->sequence);
    return std::move(*left);
}

/// What the file says is the job's, and the same for all its layers.
const SavedCheckpoint& CheckpointDesk::facts_of(const KeptState& state) {
    if (facts_generation_ != state.job->generation) {
        facts_generation_ = state.job->generation;
        const auto profile = job_profile(state.job->view);
        facts_.job_bytes = state.job->blob.size();
        facts_.profile_hash = place_.profile_hash;
        facts_.is_simulator = place_.is_simulator;
        facts_.segment_name = place_.segment_name;
        facts_.source_name = std::string{state.job->view.source_name()};
        facts_.tool = profile ? tool_text(profile->tool) : std::string{};
    }
    facts_.checkpoint = state.checkpoint;
    facts_.written_s = state.written_s;
    facts_.sequence = ++sequence_;
    return facts_;
}

/// Less than what is carved is safe to go on with; more, or of a piece that lies on the table no more, is
/// not.
bool CheckpointDesk::may_stay(const Checkpoint& now) const noexcept {
    return written_ && written_->job_checksum == now.job_checksum && written_->next_layer <= now.next_layer &&
           written_->earlier_layer == now.earlier_layer;
}

void CheckpointDesk::write_newest() {
    const auto state = states.take();
    if (state == nullptr) return;
    auto done = make_state_folder(place_.folder);
    if (done) done = save_checkpoint(facts_of(*state), names_.checkpoint());
    if (!done) return mend(*state, done.error());
    written_ = state->checkpoint;
    has_failed_ = false;
    has_lied_ = false;
}

/// It could not be written: what stands there may stay, or must go.
void CheckpointDesk::mend(const KeptState& state, const Error& why) {
    if (!may_stay(state.checkpoint)) {
        if (const auto gone = withdraw_file(names_.checkpoint()); gone) {
            written_.reset();
        } else if (!std::exchange(has_lied_, true)) {
            has_failed_ = true;
            return rtcore::try_to_say(
                why.message + "; " + gone.error().message +
                "; what it tells is not of the piece that is being carved: if the computer is switched "
                "off, do not go on by it");
        }
    }
    if (!std::exchange(has_failed_, true)) {
        rtcore::try_to_say(why.message +
                           "; if the computer is switched off, nobody knows how far the piece has come");
    }
}

void CheckpointDesk::forget(const RecordName& record) {
    if (const auto gone = withdraw_record(names_.checkpoint(), record); !gone)
        return rtcore::try_to_say(gone.error().message + ": the piece is not forgotten");
    if (written_ && written_->job_checksum == record.job_checksum) written_.reset();
    ::unlink(names_.job(record.job_checksum).c_str());
}

void CheckpointDesk::copy_newest() {
    const auto job = jobs.take();
    if (job == nullptr) return;
    const auto copied = copy(**job);
    if (!copied) {
        rtcore::try_to_say(copied.error().message +
                           "; after the computer was switched off publish it from its own file");
    }
    remove_other_jobs(names_.job((*job)->checksum));
}

Result<void> CheckpointDesk::copy(const LoadedJob& job) const {
    const std::string path = names_.job(job.checksum);
    // Whole, or it would not have its name.
    if (is_snapshot_file(path)) return {};
    if (const auto made = make_state_folder(place_.folder); !made) return made.error();
    if (const auto room = check_room_for(job.blob.size(), place_.folder); !room) return room.error();
    return save_job_for_everybody(job.blob, path);
}

/// Empty: all of them.
void CheckpointDesk::remove_other_jobs(const std::string& path) const {
    std::error_code error;
    std::vector<std::string> others;
    for (const auto& entry : std::filesystem::directory_iterator{place_.folder, error}) {
        const std::string other = place_.folder + "/" + entry.path().filename().string();
        if (other != path && names_.is_job(other)) others.push_back(other);
    }
    for (const std::string& other : others) ::unlink(other.c_str());
}

}  // namespace psicarve::supervisor
