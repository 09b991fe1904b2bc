// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/checkpoint_file.hpp"

#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "rtcore/newest.hpp"
#include "rtcore/words.hpp"
#include "shared/snapshot_file.hpp"
#include "shared/state_place.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::seconds kReadingPatience{2};
constexpr mode_t kFolderMode = 0755;

std::int64_t seconds_now() {
    using std::chrono::system_clock;
    return std::chrono::duration_cast<std::chrono::seconds>(system_clock::now().time_since_epoch()).count();
}

/// For everybody to look into, whatever the umask; one that is there stays as it is.
Result<void> make_folder(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    fs::create_directories(fs::path{folder}.parent_path(), error);
    if (::mkdir(folder.c_str(), kFolderMode) == 0) {
        static_cast<void>(::chmod(folder.c_str(), kFolderMode));
    } else if (errno != EEXIST) {
        return bad_input(folder + ": cannot be made: " + std::generic_category().message(errno));
    }
    return {};
}

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

std::optional<SavedCheckpoint> read_left(const std::string& path) {
    auto left = load_saved_checkpoint(path);
    if (left) return std::move(*left);
    std::error_code error;
    if (std::filesystem::exists(path, error))
        rtcore::try_to_say(left.error().message + ": nothing is known of an unfinished piece");
    return std::nullopt;
}

}  // namespace

/// Shared by the threads; each member is one's alone, but for those that wait.
struct CheckpointFile::Desk {
    explicit Desk(CheckpointPlace whose)
        : place(std::move(whose)), names(place.folder, place.segment_name, place.is_simulator) {}

    struct KeptState {
        Checkpoint checkpoint;
        std::shared_ptr<const LoadedJob> job;
        std::int64_t written_s;
    };

    void write_newest();
    void copy_newest();

    CheckpointPlace place;
    StateNames names;
    rtcore::Newest<KeptState> states;
    rtcore::Newest<std::shared_ptr<const LoadedJob>> jobs;

private:
    const SavedCheckpoint& facts_of(const KeptState& state);
    bool may_stay(const Checkpoint& now) const noexcept;
    Result<void> copy(const LoadedJob& job) const;
    void remove_other_jobs(const std::string& path) const;

    SavedCheckpoint facts_;  ///< of the job, and of the state written last
    std::optional<Checkpoint> written_;
    std::uint64_t facts_generation_ = 0;
    bool has_failed_ = false;
};

/// What the file says is the job's, and the same for all its layers.
const SavedCheckpoint& CheckpointFile::Desk::facts_of(const KeptState& state) {
    if (facts_generation_ != state.job->generation) {
        facts_generation_ = state.job->generation;
        const auto profile = job_profile(state.job->view);
        facts_.job_bytes = state.job->blob.size();
        facts_.profile_hash = place.profile_hash;
        facts_.is_simulator = place.is_simulator;
        facts_.source_name = std::string{state.job->view.source_name()};
        facts_.tool = profile ? tool_text(profile->tool) : std::string{};
    }
    facts_.checkpoint = state.checkpoint;
    facts_.written_s = state.written_s;
    return facts_;
}

/// Less than what is carved is safe to go on with; more, or of a piece that lies on the table no more, is
/// not.
bool CheckpointFile::Desk::may_stay(const Checkpoint& now) const noexcept {
    return written_ && written_->job_checksum == now.job_checksum && written_->next_layer <= now.next_layer &&
           written_->earlier_layer == now.earlier_layer;
}

void CheckpointFile::Desk::write_newest() {
    const auto state = states.take();
    if (state == nullptr) return;
    auto done = make_folder(place.folder);
    if (done) done = save_checkpoint(facts_of(*state), names.checkpoint());
    if (done) {
        written_ = state->checkpoint;
        has_failed_ = false;
        return;
    }
    if (!may_stay(state->checkpoint)) {
        written_.reset();
        ::unlink(names.checkpoint().c_str());
    }
    if (!std::exchange(has_failed_, true)) {
        rtcore::try_to_say(done.error().message +
                           "; if the computer is switched off, nobody knows how far the piece has come");
    }
}

void CheckpointFile::Desk::copy_newest() {
    const auto job = jobs.take();
    if (job == nullptr) return;
    const auto copied = copy(**job);
    if (!copied) {
        rtcore::try_to_say(copied.error().message +
                           "; after the computer was switched off publish it from its own file");
    }
    remove_other_jobs(names.job((*job)->checksum));
}

Result<void> CheckpointFile::Desk::copy(const LoadedJob& job) const {
    const std::string path = names.job(job.checksum);
    // Whole, or it would not have its name.
    if (is_snapshot_file(path)) return {};
    if (const auto made = make_folder(place.folder); !made) return made.error();
    if (const auto room = check_room_for(job.blob.size(), place.folder); !room) return room.error();
    return save_job_for_everybody(job.blob, path);
}

void CheckpointFile::Desk::remove_other_jobs(const std::string& path) const {
    std::error_code error;
    std::vector<std::string> others;
    for (const auto& entry : std::filesystem::directory_iterator{place.folder, error}) {
        const std::string other = place.folder + "/" + entry.path().filename().string();
        if (other != path && names.is_job(other)) others.push_back(other);
    }
    for (const std::string& other : others) ::unlink(other.c_str());
}

CheckpointFile::CheckpointFile(CheckpointPlace place) {
    if (place.folder.empty()) return;
    desk_ = std::make_shared<Desk>(std::move(place));
    checkpoints_ = std::make_unique<rtcore::SideThread>();
    jobs_ = std::make_unique<rtcore::SideThread>();
    auto left = std::make_shared<std::promise<std::optional<SavedCheckpoint>>>();
    reading_ = left->get_future();
    checkpoints_->do_later([desk = desk_, left] { left->set_value(read_left(desk->names.checkpoint())); });
    static_cast<void>(reading_.wait_for(kReadingPatience));
}

void CheckpointFile::keep(const Checkpoint& checkpoint, const std::shared_ptr<const LoadedJob>& job) {
    if (desk_ == nullptr) return;
    if (desk_->states.put({checkpoint, job, seconds_now()}))
        checkpoints_->do_later([desk = desk_] { desk->write_newest(); });
    if (copied_job_ == job->checksum) return;
    copied_job_ = job->checksum;
    if (desk_->jobs.put(job)) jobs_->do_later([desk = desk_] { desk->copy_newest(); });
}

std::optional<Checkpoint> CheckpointFile::left_of(const LoadedJob& job) {
    if (reading_.valid() && reading_.wait_for(std::chrono::seconds{0}) == std::future_status::ready)
        left_ = reading_.get();
    const bool is_of_it = left_ && left_->checkpoint.job_checksum == job.checksum &&
                          left_->checkpoint.layer_count == job.view.layer_count() &&
                          left_->job_bytes == job.blob.size();
    return is_of_it ? std::optional{left_->checkpoint} : std::nullopt;
}

}  // namespace psicarve::supervisor
