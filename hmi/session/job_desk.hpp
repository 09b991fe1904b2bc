// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/prepared_job.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/session/machine_sight.hpp"
#include "hmi/session/mesh_scene.hpp"
#include "hmi/session/message_log.hpp"
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
    /// Called when a file was opened that is for this desk.
    void set_opened(std::function<void()> opened) { opened_ = std::move(opened); }

    /// A mesh, or a job or snapshot file, or a recording for whoever takes those. What is open stays open
    /// when it cannot be read.
    void open(const std::string& path);
    /// The job in a snapshot, though it is a recording.
    void open_job(const std::string& path) { post_open(path, false); }
    /// Requires a mesh.
    void slice(const cam::JobOptions& options, const Profile& profile);
    /// Requires a job.
    void publish();
    /// Ends opening, slicing or waiting for the core soon.
    void cancel() noexcept { cancels_.store(true); }

    /// At screen rate. Fetches the core's job, and shows it when nothing is open.
    void poll(const MachineSight& machine);
    const JobSight& sight() const noexcept { return sight_; }
    const std::string& path() const noexcept { return path_; }
    std::shared_ptr<const model::Mesh> mesh() const noexcept { return mesh_; }
    /// The mesh as it is drawn.
    std::shared_ptr<const MeshScene> scene() const noexcept { return scene_; }
    std::shared_ptr<const cam::PreparedJob> job() const noexcept { return job_; }
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
    struct Opened;
    using JobPointer = std::shared_ptr<const cam::PreparedJob>;

    void begin(DeskState state);
    void post_open(const std::string& path, bool may_be_recording);
    void take_opened(const std::string& path, Opened opened);
    void take_job(JobPointer job, std::uint64_t generation);
    void fail(const Error& error);
    void fetch_from_core(std::uint64_t generation);

    std::function<bool(const std::string&)> is_recording_;
    std::function<void(const std::string&)> take_recording_;
    std::function<void()> opened_;
    std::string segment_name_;
    std::string group_;
    MessageLog& log_;
    JobSight sight_;
    DeskState resting_state_ = DeskState::empty;  ///< without what is under way
    std::string path_;
    std::shared_ptr<const model::Mesh> mesh_;
    std::shared_ptr<const MeshScene> scene_;
    JobPointer job_;
    std::uint64_t generation_ = 0;  ///< of job_ in the segment; 0: not published
    JobPointer core_job_;
    std::uint64_t core_job_generation_ = 0;
    std::uint64_t accepted_generation_ = 0;  ///< by the core; 0: none
    std::uint64_t fetched_generation_ = 0;   ///< the core's job that was asked for last
    std::uint64_t edition_ = 0;
    std::atomic<bool> cancels_{false};
    std::atomic<double> progress_ratio_{0.0};
    WorkLane lane_{WorkLane::Haste::background};  // last: its thread uses the others
};

}  // namespace psicarve::session
