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
#include "hmi/session/file_watch.hpp"
#include "hmi/session/machine_sight.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/opened_file.hpp"
#include "hmi/session/refused_file.hpp"
#include "hmi/session/remedy.hpp"
#include "hmi/session/work_lane.hpp"

namespace psicarve::session {

/// The model or job that is open, and its way to the core. Files, slicing and publishing happen on a thread
/// of their own; what becomes of them is a message. One thread, the owner's.
class JobDesk {
public:
    JobDesk(std::string segment_name, std::string group, MessageLog& log);
    ~JobDesk();
    /// Files that are not for this desk, and who takes them. `is_one` may read the file.
    void set_recordings(std::function<bool(const std::string&)> is_one,
                        std::function<void(const std::string&)> take) {
        is_recording_ = std::move(is_one);
        take_recording_ = std::move(take);
    }
    /// The machine's own, whose tool engraves open lines.
    void set_profile(std::function<Profile()> profile) { profile_ = std::move(profile); }
    /// How a table becomes a job as soon as it is opened.
    void set_table_way(std::function<TableWay()> way) { way_ = std::move(way); }
    /// Called when a file was opened that is for this desk.
    void set_opened(std::function<void()> opened) { opened_ = std::move(opened); }

    /// A mesh, drawing, picture or table, or a job or snapshot file, or a recording for whoever takes those.
    /// What is open stays open when it cannot be read. A drawing of open lines alone is engraved.
    void open(const std::string& path);
    /// The job in a snapshot, though it is a recording.
    void open_job(const std::string& path) { post_open(path, false); }
    /// The file that was to be opened last and could not be, until the next one is asked for.
    const std::optional<RefusedFile>& refused_file() const noexcept { return refused_file_; }
    void refuse(const std::string& path, Phrase why) {
        log_.add(Severity::warning, why);
        refused_file_ = {path, std::move(why)};
    }
    void forget_refused_file() noexcept { refused_file_.reset(); }
    /// The slicing or publishing that was asked for last and refused, until anything else is asked for.
    const std::optional<DeskRefusal>& refusal() const noexcept { return refusal_; }
    /// It was about fields that are others now.
    void forget_refusal() noexcept { refusal_.reset(); }
    /// The file that is open was written since.
    bool has_changed() const noexcept { return watch_.has_changed(); }
    /// In what state the file that is open was read; nothing where that is not known.
    std::optional<FileWatch::Stamp> stamp() const { return watch_.opened(); }
    /// Makes another body of the drawing or picture that is open; none when it cannot be made, until the next
    /// wish: what is sliced is what was asked for.
    void reshape(const flat::FlatOptions& options);
    /// What the body was last asked to be made with.
    const flat::FlatOptions& shape() const noexcept { return shape_; }
    /// Turns and mirrors the model as it is in its file, this one and as often as it is read again; another
    /// file is as it is.
    void turn(const model::MeshTurn& turn);
    /// Requires a mesh, or a table, which is read again and takes nothing of the options but how layers are
    /// joined.
    void slice(const cam::JobOptions& options, const Profile& profile);
    /// Requires a job.
    void publish();
    /// Puts core_job() on the desk in place of what is open; a file stays when that job was made of it here.
    /// Nothing while the desk is busy, or where there is no other job to take. `saved`: the job that was
    /// saved last; another one that goes and was not published either is told.
    void take_over(const cam::PreparedJob* saved = nullptr);
    bool can_take_over() const noexcept { return !sight_.is_busy() && core_job() && core_job() != job_; }
    /// Ends opening, slicing or waiting for the core soon.
    void cancel() noexcept { cancels_.store(true); }

    /// At screen rate. Fetches the core's job, and shows it when nothing is open and none was taken over.
    void poll(const MachineSight& machine);
    const JobSight& sight() const noexcept { return sight_; }
    const std::string& path() const noexcept { return path_; }
    std::shared_ptr<const model::Mesh> mesh() const noexcept { return mesh_; }
    /// What the mesh was made of.
    flat::ModelKind kind() const noexcept { return kind_; }
    /// Of its file; 0 when it is not known.
    std::uint64_t mesh_bytes() const noexcept { return mesh_bytes_; }
    /// The mesh as it is drawn.
    std::shared_ptr<const MeshScene> scene() const noexcept { return scene_; }
    std::shared_ptr<const cam::PreparedJob> job() const noexcept { return job_; }
    /// How the job was made of the table that is open; nothing: none is.
    const std::optional<TableWay>& table_way() const noexcept { return table_way_; }
    /// The job was taken over: the file that is open was made into another one since.
    bool is_taken_over() const noexcept { return job_ && job_ == taken_job_; }
    /// What the job was sliced from, as it was turned then; null: it was opened as a job.
    std::shared_ptr<const model::Mesh> job_mesh() const noexcept { return job_mesh_; }
    /// The job that the core accepted last: what the machine carves, whatever is open here. Null while it is
    /// not known.
    std::shared_ptr<const cam::PreparedJob> core_job() const noexcept {
        return accepted_generation_ == core_job_generation_ ? core_job_ : nullptr;
    }
    /// Of the slicing; 0 to 1.
    double progress_ratio() const noexcept { return progress_ratio_.load(); }
    /// Grows when another mesh or job is there to be shown.
    std::uint64_t edition() const noexcept { return edition_; }

private:
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;

    void begin(DeskState state);
    void post_open(const std::string& path, bool may_be_recording);
    void turn_again();
    void make_table_job(TableWay way);
    void take_body(OpenedFile opened);
    void compare_profiles(const MachineSight& machine);
    bool is_of_checkpoint(const MachineSight& machine);
    void take_opened(const std::string& path, const TableWay& way, OpenedFile opened);
    void watch(const std::optional<FileWatch::Stamp>& opened);
    void note_change();
    void take_job(JobPointer job, std::uint64_t generation, std::shared_ptr<const model::Mesh> mesh = {});
    void drop_job();
    void tell_unkept(const cam::PreparedJob* saved);
    void close_file();
    void fail(const Error& error);
    void refuse_desk(DeskRefusal::Of of, const Error& error, std::vector<Remedy> remedies);
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
    JobSight sight_;
    DeskState resting_state_ = DeskState::empty;  ///< without what is under way
    std::string path_;
    std::optional<RefusedFile> refused_file_;
    std::optional<DeskRefusal> refusal_;
    FileWatch watch_;
    bool is_change_told_ = false;
    std::shared_ptr<const model::Mesh> mesh_;
    std::shared_ptr<const model::Mesh> file_mesh_;  ///< before it was turned
    model::MeshTurn turn_;
    bool wishes_turn_ = false;  ///< once what is under way is done
    flat::FlatOptions shape_;
    std::shared_ptr<const cam::PreparedJob> compared_job_;  ///< whose profile was held against the core's
    std::uint64_t compared_hash_ = 0;
    JobPointer summed_job_;  ///< of which `job_sum_` is the checksum
    std::uint64_t job_sum_ = 0;
    flat::ModelKind kind_ = flat::ModelKind::mesh;
    std::optional<flat::FlatOptions> wished_;  ///< another body, once what is under way is done
    std::shared_ptr<const MeshScene> scene_;
    std::uint64_t mesh_bytes_ = 0;
    JobPointer job_;
    std::shared_ptr<const model::Mesh> job_mesh_;
    std::uint64_t generation_ = 0;  ///< of job_ in the segment; 0: not published
    JobPointer core_job_;
    std::shared_ptr<const model::Mesh> core_job_mesh_;  ///< that it was sliced from here; else null
    std::string core_job_path_;                         ///< of the file that it was made of here; else empty
    JobPointer taken_job_;
    std::uint64_t core_job_generation_ = 0;
    std::uint64_t accepted_generation_ = 0;  ///< by the core; 0: none
    std::uint64_t fetched_generation_ = 0;   ///< the core's job that was asked for last
    std::uint64_t edition_ = 0;
    std::atomic<bool> cancels_{false};
    std::atomic<double> progress_ratio_{0.0};
    WorkLane lane_{WorkLane::Haste::background};  // last: its thread uses the others
};

}  // namespace psicarve::session
