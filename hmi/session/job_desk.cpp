// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_desk.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "hmi/cam/least_time.hpp"
#include "hmi/machine/machine_link.hpp"
#include "hmi/model/load_mesh.hpp"
#include "hmi/session/error_phrase.hpp"
#include "hmi/session/warning_phrase.hpp"
#include "shared/snapshot_file.hpp"

namespace psicarve::session {

/// One of them.
struct JobDesk::Opened {
    std::shared_ptr<const model::Mesh> mesh;
    std::shared_ptr<const MeshScene> scene;
    JobPointer job;
    std::optional<Error> error;
};

namespace {

using machine::MachineLink;
using JobPointer = std::shared_ptr<const cam::PreparedJob>;

constexpr std::chrono::milliseconds kJudgePoll{100};
constexpr std::chrono::milliseconds kCopyLimit{2000};

JobPointer shared(cam::PreparedJob&& job) {
    job.least_seconds = cam::least_carving_seconds(job.view, job.profile);
    return std::make_shared<const cam::PreparedJob>(std::move(job));
}

Result<JobPointer> read_job(const std::string& path) {
    auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    auto job = cam::prepare_snapshot(std::move(snapshot).value(), path);
    if (!job) return job.error();
    return shared(std::move(*job));
}

Result<JobPointer> make_job(const model::Mesh& mesh, const Profile& profile, const cam::JobOptions& options) {
    auto built = cam::build_job(mesh, profile, options);
    if (!built) return built.error();
    auto job = cam::prepare_blob(job_blob_from_table(built->table), profile, mesh.source_name);
    if (!job) return job.error();
    job->warnings = std::move(built->report.warnings);
    job->notes = std::move(built->report.notes);
    return shared(std::move(*job));
}

/// Publishes, and waits for the core's word until it comes or the wait is cancelled.
Result<std::uint64_t> publish_and_wait(const std::string& segment, const std::string& group,
                                       const cam::PreparedJob& job, const std::atomic<bool>& cancels) {
    auto link = MachineLink::attach(segment, group);
    if (!link) return link.error();
    if (const auto core = link->require_core(); !core) return core.error();
    const auto generation = publish_job(link->segment(), job.blob);
    while (generation) {
        const auto accepted = wait_for_acceptance(link->segment(), *generation, kJudgePoll);
        if (accepted) break;
        if (accepted.error().code != ErrorCode::timed_out) return accepted.error();
        if (cancels.load()) return Error{ErrorCode::cancelled, "publishing was cancelled"};
    }
    return generation;
}

Result<JobPointer> job_in_segment(const std::string& segment, const std::string& group) {
    auto link = MachineLink::attach(segment, group);
    if (!link) return link.error();
    auto published = copy_current_job(link->segment(), kCopyLimit);
    if (!published) return published.error();
    const auto view = JobView::check(published->blob);
    if (!view) return view.error();
    auto profile = job_profile(*view);
    if (!profile) return profile.error();
    auto job = cam::prepare_blob(std::move(published->blob), std::move(*profile), segment);
    if (!job) return job.error();
    return shared(std::move(*job));
}

}  // namespace

JobDesk::JobDesk(std::string segment_name, std::string group, MessageLog& log)
    : segment_name_(std::move(segment_name)), group_(std::move(group)), log_(log) {}

JobDesk::~JobDesk() {
    cancel();
}

void JobDesk::begin(DeskState state) {
    sight_.state = state;
    cancels_.store(false);
    progress_ratio_.store(0.0);
}

void JobDesk::open(const std::string& path) {
    post_open(path, true);
}

void JobDesk::post_open(const std::string& path, bool may_be_recording) {
    if (sight_.is_busy()) return;
    begin(DeskState::opening);
    lane_.post([this, path, may_be_recording]() -> WorkLane::Finish {
        if (may_be_recording && is_recording_ && is_recording_(path))
            return [this, path] { take_recording_(path); };
        auto opened = std::make_shared<Opened>();
        if (is_snapshot_file(path)) {
            auto job = read_job(path);
            if (job) opened->job = *job;
            if (!job) opened->error = job.error();
        } else {
            auto mesh = model::load_mesh(path);
            if (mesh) opened->mesh = std::make_shared<const model::Mesh>(std::move(*mesh));
            if (!mesh) opened->error = mesh.error();
            if (mesh) opened->scene = std::make_shared<const MeshScene>(make_mesh_scene(*opened->mesh));
        }
        return [this, path, opened] { take_opened(path, std::move(*opened)); };
    });
}

void JobDesk::take_opened(const std::string& path, Opened opened) {
    if (cancels_.load()) opened.error = Error{ErrorCode::cancelled, path + ": opening was cancelled"};
    if (opened.error) return fail(*opened.error);
    if (opened_) opened_();
    path_ = path;
    mesh_ = std::move(opened.mesh);
    scene_ = std::move(opened.scene);
    job_.reset();
    resting_state_ = DeskState::model;
    log_.add(Severity::info, phrase("Opened %1", std::filesystem::path{path}.filename().string()));
    if (opened.job) return take_job(std::move(opened.job), 0);
    for (const std::string& warning : mesh_->warnings) log_.add(Severity::warning, warning_phrase(warning));
    ++edition_;
}

void JobDesk::slice(const cam::JobOptions& options, const Profile& profile) {
    if (sight_.is_busy() || !mesh_) return;
    begin(DeskState::slicing);
    cam::JobOptions how = options;
    const auto show = [this](double done) {
        progress_ratio_.store(done);
        return !cancels_.load();
    };
    how.progress = show;
    how.search_progress = show;
    lane_.post([this, how, profile, mesh = mesh_]() -> WorkLane::Finish {
        auto job = make_job(*mesh, profile, how);
        if (!job) return [this, error = job.error()] { fail(error); };
        return [this, made = *job] { take_job(made, 0); };
    });
}

void JobDesk::take_job(JobPointer job, std::uint64_t generation) {
    job_ = std::move(job);
    generation_ = generation;
    resting_state_ = DeskState::job;
    ++edition_;
    for (const std::string& warning : job_->warnings) log_.add(Severity::warning, warning_phrase(warning));
    for (const std::string& note : job_->notes) log_.add(Severity::info, error_phrase(note));
    log_.add(Severity::info, phrase("Job: %1 × %2 points", std::to_string(job_->view.layer_count()),
                                    std::to_string(job_->view.point_count())));
}

void JobDesk::publish() {
    if (sight_.is_busy() || !job_) return;
    begin(DeskState::publishing);
    lane_.post([this, job = job_]() -> WorkLane::Finish {
        const auto generation = publish_and_wait(segment_name_, group_, *job, cancels_);
        if (!generation) return [this, error = generation.error()] { fail(error); };
        return [this, job, number = *generation] {
            generation_ = number;
            fetched_generation_ = number;
            core_job_generation_ = number;
            core_job_ = job;
            resting_state_ = DeskState::job;
        };
    });
}

void JobDesk::fail(const Error& error) {
    const Severity severity = error.code == ErrorCode::cancelled ? Severity::info : Severity::warning;
    log_.add(severity, error_phrase(error.message));
}

void JobDesk::fetch_from_core(std::uint64_t generation) {
    fetched_generation_ = generation;
    lane_.post([this, generation]() -> WorkLane::Finish {
        const auto job = job_in_segment(segment_name_, group_);
        if (!job) return [this, error = job.error()] { fail(error); };
        return [this, made = *job, generation] {
            core_job_generation_ = generation;
            core_job_ = made;
            ++edition_;
            if (!mesh_ && path_.empty()) take_job(made, generation);
        };
    });
}

void JobDesk::poll(const MachineSight& machine) {
    const bool was_busy = sight_.is_busy();
    lane_.deliver();
    if (was_busy && !lane_.is_idle()) return;
    sight_.state = resting_state_;
    // A core that is silent for a moment still has its job.
    const bool is_there = machine.status && machine.life != CoreLife::none;
    const std::uint64_t accepted = is_there ? machine.status->job_generation : 0;
    if (job_ && generation_ != 0 && accepted == generation_) sight_.state = DeskState::published;
    sight_.has_mesh = mesh_ != nullptr;
    sight_.layer_count = job_ ? job_->view.layer_count() : 0;
    accepted_generation_ = accepted;
    sight_.core_layer_count = core_job() ? core_job()->view.layer_count() : 0;
    if (accepted != 0 && accepted != fetched_generation_ && lane_.is_idle()) fetch_from_core(accepted);
}

}  // namespace psicarve::session
