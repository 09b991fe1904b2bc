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
#include "hmi/session/job_comparison.hpp"
#include "hmi/session/machine_job.hpp"
#include "hmi/session/machine_view.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/open_model.hpp"
#include "hmi/session/opened_file.hpp"
#include "hmi/session/refused_file.hpp"
#include "hmi/session/remedy.hpp"

namespace psicarve::session {

/// The model or job that is open, and its way to the core. A thread of its own reads files, slices and
/// publishes; results become messages. All calls come from one thread, the owner's. Its members: parts, and
/// the two refusals and the state that the window shows.
class OpenJob {
public:
    OpenJob(std::string segment_name, std::string group, MessageLog& log);
    ~OpenJob();
    /// Files that this desk does not open, and the function that takes them. `is_one` may read the file.
    void set_recordings(std::function<bool(const std::string&)> is_one,
                        std::function<void(const std::string&)> take) {
        hooks_.is_recording = std::move(is_one);
        hooks_.take_recording = std::move(take);
    }
    /// The machine's profile, whose tool engraves open lines.
    void set_profile(std::function<Profile()> profile) { hooks_.profile = std::move(profile); }
    /// How a table becomes a job when it is opened.
    void set_table_way(std::function<TableWay()> way) { hooks_.table_way = std::move(way); }
    /// Called when this desk has opened a file.
    void set_opened(std::function<void()> opened) { hooks_.opened = std::move(opened); }

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
    bool has_changed() const noexcept { return file_.has_changed(); }
    /// The state in which the open file was read; nothing where that is not known.
    std::optional<FileWatch::Stamp> stamp() const { return file_.opened(); }
    /// Makes another body of the open drawing or picture; no body when it cannot be made, until the next
    /// request: slicing uses only the body that was asked for.
    void reshape(const flat::FlatOptions& options);
    /// The options last asked for.
    const flat::FlatOptions& shape() const noexcept { return model_.shape; }
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
    bool can_take_over() const noexcept { return !view_.is_busy() && core_job() && core_job() != desk_.job; }
    /// Ends opening, slicing or waiting for the core soon.
    void cancel() noexcept { task_.is_cancelled.store(true); }

    /// Call it at screen rate. Fetches the core's job, and shows it when nothing is open and none was taken
    /// over.
    void poll(const MachineView& machine);
    const OpenJobView& view() const noexcept { return view_; }
    const std::string& path() const noexcept { return file_.path(); }
    std::shared_ptr<const model::Mesh> mesh() const noexcept { return model_.mesh; }
    /// The kind of file that the mesh was made of.
    flat::ModelKind kind() const noexcept { return model_.kind; }
    /// Size of its file; 0 when it is not known.
    std::uint64_t mesh_bytes() const noexcept { return model_.bytes; }
    /// The mesh as drawn.
    std::shared_ptr<const MeshScene> scene() const noexcept { return model_.scene; }
    std::shared_ptr<const cam::PreparedJob> job() const noexcept { return desk_.job; }
    /// How the open table was made into the job; nothing: no table is open.
    const std::optional<TableWay>& table_way() const noexcept { return desk_.table_way; }
    /// The job was taken over: the open file has been made into another one since.
    bool is_taken_over() const noexcept { return desk_.job && desk_.job == desk_.taken; }
    /// The mesh that the job was sliced from, turned as it was then; null: it was opened as a job.
    std::shared_ptr<const model::Mesh> job_mesh() const noexcept { return desk_.mesh; }
    /// The job that the core accepted last: what the machine carves, whatever is open here. Null while it is
    /// not known.
    std::shared_ptr<const cam::PreparedJob> core_job() const noexcept { return machine_job_.accepted(); }
    /// Progress of the slicing; 0 to 1.
    double progress_ratio() const noexcept { return task_.progress_ratio.load(); }
    /// Grows when there is another mesh or job to show.
    std::uint64_t edition() const noexcept { return edition_; }

private:
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;

    void begin(OpenJobState state);
    void post_open(const std::string& path, bool may_be_recording);
    void turn_again();
    void make_table_job(TableWay way);
    void take_body(OpenedFile opened);
    void take_opened(const std::string& path, const TableWay& way, OpenedFile opened);
    void note_change();
    void take_job(JobPointer job, std::uint64_t generation, std::shared_ptr<const model::Mesh> mesh = {});
    void drop_job();
    void tell_unkept(const cam::PreparedJob* saved);
    void close_file();
    void fail(const Error& error);
    void refuse_desk(OpenJobRefusal::Of of, const Error& error, std::vector<Remedy> remedies);
    void fetch_from_core(std::uint64_t generation);

    /// What the owner does for it.
    struct Hooks {
        std::function<bool(const std::string&)> is_recording{};
        std::function<void(const std::string&)> take_recording{};
        std::function<void()> opened{};
        std::function<Profile()> profile = [] { return Profile{}; };
        std::function<TableWay()> table_way = [] { return TableWay{}; };
    };
    /// The job on the desk, and what it was made of.
    struct DeskJob {
        JobPointer job{};
        std::shared_ptr<const model::Mesh> mesh{};
        std::optional<TableWay> table_way{};  ///< of the open table, be there a job or none
        std::uint64_t generation = 0;         ///< in the segment; 0: not published
        JobPointer taken{};                   ///< the job that was taken over from the machine last
    };
    /// What the queue's thread and the owner tell each other while a task runs.
    struct Task {
        std::atomic<bool> is_cancelled{false};
        std::atomic<double> progress_ratio{0.0};
    };

    Hooks hooks_;
    std::string segment_name_;
    std::string group_;
    MessageLog& log_;
    OpenJobView view_;
    OpenJobState resting_state_ = OpenJobState::empty;  ///< without the task under way
    FileWatch file_;                                    ///< the open file
    std::optional<RefusedFile> refused_file_;
    std::optional<OpenJobRefusal> refusal_;
    OpenModel model_;
    DeskJob desk_;
    MachineJob machine_job_;
    JobComparison comparison_;
    std::uint64_t edition_ = 0;
    Task task_;
    BackgroundQueue queue_{BackgroundQueue::Haste::background};  // last: its thread uses the others
};

}  // namespace psicarve::session
