// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/prepared_job.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/scene/mesh_scene.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/file_watch.hpp"
#include "hmi/session/machine_view.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/opened_file.hpp"
#include "hmi/session/refused_file.hpp"
#include "hmi/session/remedy.hpp"

namespace psicarve::session {

/// The model or job that is open, and its way to the core. A thread of its own reads files, slices and
/// publishes; results become messages. All calls come from one thread, the owner's.
class OpenJob {
public:
    OpenJob(std::string segment_name, std::string group, MessageLog& log);
    ~OpenJob();
    /// Files that this desk does not open, and the function that takes them. `is_one` may read the file.
    void set_recordings(std::function<bool(const std::string&)> is_one,
                        std::function<void(const std::string&)> take) {
        is_recording_ = std::move(is_one);
        take_recording_ = std::move(take);
    }
    /// The machine's profile, whose tool engraves open lines.
    void set_profile(std::function<Profile()> profile) { profile_ = std::move(profile); }
    /// How a table becomes a job when it is opened.
    void set_table_way(std::function<TableWay()> way) { way_ = std::move(way); }
    /// Called when this desk has opened a file.
    void set_opened(std::function<void()> opened) { opened_ = std::move(opened); }

    /// Opens a mesh, drawing, picture or table, or a job or snapshot file; a recording goes to the function
    /// that takes those. The open one stays when the new one cannot be read. A drawing of open lines alone is
    /// engraved.
    void open(const std::string& path);
    /// Opens the job in a snapshot, though it is a recording.
    void open_job(const std::string& path) { post_open(path, false); }
    /// The file that was last asked for and could not be opened, until the next one is asked for.
    const std::optional<RefusedFile>& refused_file() const noexcept { return refused_file_; }
    void refuse(const std::string& path, Phrase why) {
        log_.add(Severity::warning, why);
        refused_file_ = {path, std::move(why)};
    }
    void forget_refused_file() noexcept { refused_file_.reset(); }
    /// The last slicing or publishing that was refused, until anything else is asked for.
    const std::optional<OpenJobRefusal>& refusal() const noexcept { return refusal_; }
    /// The fields that it was about have changed.
    void forget_refusal() noexcept { refusal_.reset(); }
    /// The open file was written since.
    bool has_changed() const noexcept { return watch_.has_changed(); }
    /// The state in which the open file was read; nothing where that is not known.
    std::optional<FileWatch::Stamp> stamp() const { return watch_.opened(); }
    /// Makes another body of the open drawing or picture; no body when it cannot be made, until the next
    /// request: slicing uses only the body that was asked for.
    void reshape(const flat::FlatOptions& options);
    /// The options last asked for.
    const flat::FlatOptions& shape() const noexcept { return shape_; }
    /// Turns and mirrors the model relative to its file, now and whenever it is read again; does not apply to
    /// another file.
    void turn(const model::MeshTurn& turn);
    /// Requires a mesh, or a table, which is read again and uses of the options only how layers are joined.
    void slice(const cam::JobOptions& options, const Profile& profile);
    /// Requires a job.
    void publish();
    /// Puts core_job() on the desk in place of what is open; a file stays when that job was made of it here.
    /// Does nothing while the desk is busy, or where there is no other job to take. `saved`: the job saved
    /// last; reports a job that is dropped without having been saved or published.
    void take_over(const cam::PreparedJob* saved = nullptr);
    bool can_take_over() const noexcept { return !view_.is_busy() && core_job() && core_job() != job_; }
    /// Ends opening, slicing or waiting for the core soon.
    void cancel() noexcept { cancels_.store(true); }

    /// Call it at screen rate. Fetches the core's job, and shows it when nothing is open and none was taken
    /// over.
    void poll(const MachineView& machine);
    const OpenJobView& view() const noexcept { return view_; }
    const std::string& path() const noexcept { return path_; }
    std::shared_ptr<const model::Mesh> mesh() const noexcept { return mesh_; }
    /// The kind of file that the mesh was made of.
    flat::ModelKind kind() const noexcept { return kind_; }
    /// Size of its file; 0 when it is not known.
    std::uint64_t mesh_bytes() const noexcept { return mesh_bytes_; }
    /// The mesh as drawn.
    std::shared_ptr<const MeshScene> scene() const noexcept { return scene_; }
    std::shared_ptr<const cam::PreparedJob> job() const noexcept { return job_; }
    /// How the open table was made into the job; nothing: no table is open.
    const std::optional<TableWay>& table_way() const noexcept { return table_way_; }
    /// The job was taken over: the open file has been made into another one since.
    bool is_taken_over() const noexcept { return job_ && job_ == taken_job_; }
    /// The mesh that the job was sliced from, turned as it was then; null: it was opened as a job.
    std::shared_ptr<const model::Mesh> job_mesh() const noexcept { return job_mesh_; }
    /// The job that the core accepted last: what the machine carves, whatever is open here. Null while it is
    /// not known.
    std::shared_ptr<const cam::PreparedJob> core_job() const noexcept {
        return accepted_generation_ == core_job_generation_ ? core_job_ : nullptr;
    }
    /// Progress of the slicing; 0 to 1.
    double progress_ratio() const noexcept { return progress_ratio_.load(); }
    /// Grows when there is another mesh or job to show.
    std::uint64_t edition() const noexcept { return edition_; }

private:
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;

    void begin(OpenJobState state);
    void post_open(const std::string& path, bool may_be_recording);
    void turn_again();
    void make_table_job(TableWay way);
    void take_body(OpenedFile opened);
    void compare_profiles(const MachineView& machine);
    bool is_of_checkpoint(const MachineView& machine);
    void take_opened(const std::string& path, const TableWay& way, OpenedFile opened);
    void watch(const std::optional<FileWatch::Stamp>& opened);
    void note_change();
    void take_job(JobPointer job, std::uint64_t generation, std::shared_ptr<const model::Mesh> mesh = {});
    void drop_job();
    void tell_unkept(const cam::PreparedJob* saved);
    void close_file();
    void fail(const Error& error);
    void refuse_desk(OpenJobRefusal::Of of, const Error& error, std::vector<Remedy> remedies);
    void fetch_from_core(std::uint64_t generation);

    std::function<bool(const std::string&)> is_recording_;
    std::function<void(const std::string&)> take_recording_;
    std::function<void()> opened_;
    std::function<Profile()> profile_ = [] { return Profile{}; };
    std::function<TableWay()> way_ = [] { return TableWay{}; };
    std::optional<TableWay> table_way_;
    std::string segment_name_;
    std::string group_;
    MessageLog& log_;
    OpenJobView view_;
    OpenJobState resting_state_ = OpenJobState::empty;  ///< without the task under way
    std::string path_;
    std::optional<RefusedFile> refused_file_;
    std::optional<OpenJobRefusal> refusal_;
    FileWatch watch_;
    bool is_change_told_ = false;
    std::shared_ptr<const model::Mesh> mesh_;
    std::shared_ptr<const model::Mesh> file_mesh_;  ///< before it was turned
    model::MeshTurn turn_;
    bool wishes_turn_ = false;  ///< turn it once the task under way is done
    flat::FlatOptions shape_;
    std::shared_ptr<const cam::PreparedJob> compared_job_;  ///< the job whose profile was compared with the
                                                            ///< core's
    std::uint64_t compared_hash_ = 0;
    JobPointer summed_job_;  ///< the job with the checksum `job_sum_`
    std::uint64_t job_sum_ = 0;
    flat::ModelKind kind_ = flat::ModelKind::mesh;
    std::optional<flat::FlatOptions> wished_;  ///< another body, to be made once the task under way is done
    std::shared_ptr<const MeshScene> scene_;
    std::uint64_t mesh_bytes_ = 0;
    JobPointer job_;
    std::shared_ptr<const model::Mesh> job_mesh_;
    std::uint64_t generation_ = 0;  ///< of job_ in the segment; 0: not published
    JobPointer core_job_;
    std::shared_ptr<const model::Mesh> core_job_mesh_;  ///< the mesh that it was sliced from here; else null
    std::string core_job_path_;                         ///< the file that it was made of here; else empty
    JobPointer taken_job_;
    std::uint64_t core_job_generation_ = 0;
    std::uint64_t accepted_generation_ = 0;  ///< accepted by the core; 0: none
    std::uint64_t fetched_generation_ = 0;   ///< of the core's job that was asked for last
    std::uint64_t edition_ = 0;
    std::atomic<bool> cancels_{false};
    std::atomic<double> progress_ratio_{0.0};
    BackgroundQueue queue_{BackgroundQueue::Haste::background};  // last: its thread uses the others
};

}  // namespace psicarve::session
