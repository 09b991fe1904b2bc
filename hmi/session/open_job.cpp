// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/open_job.hpp"

#include <filesystem>
#include <optional>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/phrase/warning_phrase.hpp"
#include "hmi/session/core_job.hpp"
#include "hmi/session/job_making.hpp"
#include "hmi/session/start_place.hpp"

namespace psicarve::session {

namespace {

using JobPointer = std::shared_ptr<const cam::PreparedJob>;
using MeshPointer = std::shared_ptr<const model::Mesh>;

Result<JobPointer> make_job(const model::Mesh& mesh, const Profile& profile, const cam::JobOptions& options) {
    auto built = cam::build_job(mesh, profile, options);
    if (!built) return built.error();
    return prepared(std::move(*built), profile, mesh.source_name);
}

}  // namespace

OpenJob::OpenJob(std::string segment_name, std::string group, MessageLog& log)
    : segment_name_(std::move(segment_name)), group_(std::move(group)), log_(log) {}

OpenJob::~OpenJob() {
    cancel();
}

void OpenJob::begin(OpenJobState state) {
    view_.state = state;
    refusal_.reset();
    cancels_.store(false);
    progress_ratio_.store(0.0);
}

void OpenJob::open(const std::string& path) {
    post_open(path, true);
}

void OpenJob::post_open(const std::string& path, bool may_be_recording) {
    if (view_.is_busy()) return;
    begin(OpenJobState::opening);
    refused_file_.reset();
    // The same file again gets the form's settings.
    const bool is_same = path == path_;
    const model::MeshTurn turn = is_same ? turn_ : model::MeshTurn{};
    const std::optional<flat::FlatOptions> shape = is_same ? std::optional{shape_} : std::nullopt;
    queue_.post([this, path, may_be_recording, turn, shape, machine = profile_(),
                 way = way_()]() -> BackgroundQueue::Finish {
        if (may_be_recording && is_recording_ && is_recording_(path))
            return [this, path] { take_recording_(path); };
        const auto stamp = FileWatch::stamp_of(path);
        const auto opened = std::make_shared<OpenedFile>(read_opened(path, machine, shape, turn, way));
        opened->stamp = stamp;
        return [this, path, way, opened] { take_opened(path, way, std::move(*opened)); };
    });
}

void OpenJob::reshape(const flat::FlatOptions& options) {
    if (path_.empty() || kind_ == flat::ModelKind::mesh) return;
    wished_ = options;
    shape_ = options;
    if (view_.is_busy()) return;  // poll() comes back to it
    wished_.reset();
    begin(OpenJobState::opening);
    queue_.post([this, path = path_, options, turn = turn_]() -> BackgroundQueue::Finish {
        const auto stamp = FileWatch::stamp_of(path);
        const auto opened = std::make_shared<OpenedFile>(read_opened_model(path, options, turn));
        opened->stamp = stamp;
        return [this, opened] {
            watch(opened->stamp);
            take_body(std::move(*opened));
        };
    });
}

/// Another body of the same file, or none: never one that was not asked for.
void OpenJob::take_body(OpenedFile opened) {
    if (cancels_.load()) {
        opened = {};
        opened.error = Error{ErrorCode::cancelled, path_ + ": opening was cancelled"};
    }
    if (opened.error) fail(*opened.error);
    mesh_ = std::move(opened.mesh);
    file_mesh_ = std::move(opened.file_mesh);
    scene_ = std::move(opened.scene);
    drop_job();
    resting_state_ = mesh_ ? OpenJobState::model : OpenJobState::empty;
    ++edition_;
}

void OpenJob::turn(const model::MeshTurn& turn) {
    if (turn == turn_) return;
    turn_ = turn;
    wishes_turn_ = true;
    if (!view_.is_busy()) turn_again();  // else poll() comes back to it
}

void OpenJob::turn_again() {
    wishes_turn_ = false;
    if (!file_mesh_) return;
    begin(OpenJobState::opening);
    queue_.post([this, mesh = file_mesh_, turn = turn_]() -> BackgroundQueue::Finish {
        const auto opened = std::make_shared<OpenedFile>(turned_again(mesh, turn));
        return [this, opened] { take_body(std::move(*opened)); };
    });
}

void OpenJob::take_opened(const std::string& path, const TableWay& way, OpenedFile opened) {
    if (cancels_.load()) opened.error = Error{ErrorCode::cancelled, path + ": opening was cancelled"};
    const bool is_cancelled = cancels_.load();
    // Lines that do not fit the default cylinder stay open, so that the user can choose another one.
    const bool is_refused = opened.error && !is_cancelled && !opened.is_line_art;
    if (is_refused) return refuse(path, error_phrase(*opened.error));
    if (opened.error) fail(*opened.error);
    if (is_cancelled) return;
    if (opened_) opened_();
    wished_.reset();
    if (path != path_) {
        turn_ = {};
        wishes_turn_ = false;
    }
    shape_ = opened.shape;
    table_way_ = opened.is_table ? std::optional{way} : std::nullopt;
    path_ = path;
    watch(opened.stamp);
    mesh_ = std::move(opened.mesh);
    file_mesh_ = std::move(opened.file_mesh);
    kind_ = opened.kind;
    scene_ = std::move(opened.scene);
    mesh_bytes_ = opened.mesh_bytes;
    drop_job();
    resting_state_ = mesh_ || opened.job ? OpenJobState::model : OpenJobState::empty;
    const std::string name = std::filesystem::path{path}.filename().string();
    log_.add(Severity::info, phrase("Opened %1", name));
    if (opened.job) return take_job(std::move(opened.job), 0);
    ++edition_;
    if (opened.is_line_art)
        log_.add(Severity::warning, phrase("%1 has no closed outline: its lines are engraved", name));
    if (!mesh_) return;
    for (const std::string& warning : mesh_->warnings) log_.add(Severity::warning, warning_phrase(warning));
}

void OpenJob::watch(const std::optional<FileWatch::Stamp>& opened) {
    watch_.watch(path_, opened);
    is_change_told_ = false;
}

void OpenJob::note_change() {
    watch_.poll(FileWatch::Clock::now());
    if (!watch_.has_changed() || is_change_told_) return;
    is_change_told_ = true;
    log_.add(Severity::warning, phrase("%1 was written since it was opened: Reload takes it as it is now",
                                       std::filesystem::path{path_}.filename().string()));
}

void OpenJob::slice(const cam::JobOptions& options, const Profile& profile) {
    if (view_.is_busy()) return;
    if (table_way_) return make_table_job({profile, options.joining});
    if (!mesh_) return;
    begin(OpenJobState::slicing);
    cam::JobOptions how = options;
    const auto show = [this](double done) {
        progress_ratio_.store(done);
        return !cancels_.load();
    };
    how.progress = show;
    how.search_progress = show;
    const bool is_mesh = kind_ == flat::ModelKind::mesh;
    queue_.post([this, how, profile, is_mesh, mesh = mesh_]() -> BackgroundQueue::Finish {
        auto job = make_job(*mesh, profile, how);
        if (!job) {
            auto remedies =
                is_mesh ? slicing_remedies(job.error(), *mesh, profile, how) : std::vector<Remedy>{};
            return [this, error = job.error(), remedies] {
                refuse_desk(OpenJobRefusal::Of::slicing, error, remedies);
            };
        }
        return [this, made = *job, mesh] { take_job(made, 0, mesh); };
    });
}

void OpenJob::make_table_job(TableWay way) {
    begin(OpenJobState::slicing);
    queue_.post([this, path = path_, way = std::move(way)]() -> BackgroundQueue::Finish {
        const auto stamp = FileWatch::stamp_of(path);
        auto job = job_of_table(path, way);
        if (cancels_.load()) job = Error{ErrorCode::cancelled, path + ": slicing was cancelled"};
        if (!job) {
            return [this, error = job.error()] { refuse_desk(OpenJobRefusal::Of::slicing, error, {}); };
        }
        return [this, way, stamp, made = *job] {
            table_way_ = way;
            watch(stamp);
            take_job(made, 0);
        };
    });
}

void OpenJob::drop_job() {
    job_.reset();
    job_mesh_.reset();
}

void OpenJob::take_job(JobPointer job, std::uint64_t generation, MeshPointer mesh) {
    job_ = std::move(job);
    job_mesh_ = std::move(mesh);
    generation_ = generation;
    resting_state_ = OpenJobState::job;
    ++edition_;
    const auto known = job_mesh_ ? job_mesh_->warnings : std::vector<std::string>{};
    for (const std::string& warning : other_warnings(job_->warnings, known))
        log_.add(Severity::warning, warning_phrase(warning));
    for (const std::string& note : job_->notes) log_.add(Severity::info, error_phrase(note));
    log_.add(Severity::info, phrase("Job: %1 × %2 points", std::to_string(job_->view.layer_count()),
                                    std::to_string(job_->view.point_count())));
}

void OpenJob::publish() {
    if (view_.is_busy() || !job_) return;
    begin(OpenJobState::publishing);
    queue_.post([this, job = job_, mesh = job_mesh_, path = path_]() -> BackgroundQueue::Finish {
        const auto generation = publish_and_wait(segment_name_, group_, *job, cancels_);
        if (!generation) {
            return [this, error = generation.error()] {
                const bool is_sliceable = mesh_ != nullptr || table_way_;
                refuse_desk(OpenJobRefusal::Of::publishing, error,
                            is_sliceable ? publishing_remedies(error) : std::vector<Remedy>{});
            };
        }
        return [this, job, mesh, path, number = *generation] {
            generation_ = number;
            fetched_generation_ = number;
            core_job_generation_ = number;
            core_job_ = job;
            core_job_mesh_ = mesh;
            core_job_path_ = path;
            resting_state_ = OpenJobState::job;
        };
    });
}

void OpenJob::take_over(const cam::PreparedJob* saved) {
    if (!can_take_over()) return;
    const JobPointer job = core_job();
    // Its body may have been made anew since.
    const bool is_of_open = !core_job_path_.empty() && core_job_path_ == path_;
    if (!is_of_open) {
        tell_unkept(saved);
        close_file();
    }
    if (opened_) opened_();
    refusal_.reset();
    taken_job_ = job;
    log_.add(Severity::info, phrase("Taken over from the machine: %1", std::string{job->view.source_name()}));
    take_job(job, core_job_generation_, core_job_mesh_);
}

/// A sliced job is not dropped without a message.
void OpenJob::tell_unkept(const cam::PreparedJob* saved) {
    const bool is_sliced = job_mesh_ != nullptr || table_way_;
    if (!job_ || !is_sliced || generation_ != 0 || job_.get() == saved) return;
    log_.add(Severity::warning,
             phrase("Closed: %1, neither published nor saved", std::string{job_->view.source_name()}));
}

void OpenJob::close_file() {
    path_.clear();
    watch({});
    refused_file_.reset();
    mesh_.reset();
    file_mesh_.reset();
    scene_.reset();
    mesh_bytes_ = 0;
    kind_ = flat::ModelKind::mesh;
    table_way_.reset();
    wished_.reset();
    shape_ = {};
    turn_ = {};
    wishes_turn_ = false;
    drop_job();
}

void OpenJob::fail(const Error& error) {
    const Severity severity = error.code == ErrorCode::cancelled ? Severity::info : Severity::warning;
    log_.add(severity, error_phrase(error));
}

void OpenJob::refuse_desk(OpenJobRefusal::Of of, const Error& error, std::vector<Remedy> remedies) {
    fail(error);
    if (error.code == ErrorCode::cancelled) return;
    const std::string name = mesh_ ? mesh_->source_name : path_;
    refusal_ = {of, name, error_phrase(error), std::move(remedies)};
}

void OpenJob::fetch_from_core(std::uint64_t generation) {
    fetched_generation_ = generation;
    queue_.post([this, generation]() -> BackgroundQueue::Finish {
        const auto job = job_in_segment(segment_name_, group_);
        if (!job) return [this, error = job.error()] { fail(error); };
        return [this, made = *job, generation] {
            core_job_generation_ = generation;
            core_job_ = made;
            core_job_mesh_.reset();
            core_job_path_.clear();
            ++edition_;
            // A job that the user has taken over stays until they take another.
            if (!mesh_ && path_.empty() && !is_taken_over()) take_job(made, generation);
        };
    });
}

void OpenJob::poll(const MachineView& machine) {
    const bool was_busy = view_.is_busy();
    queue_.deliver();
    note_change();
    if (was_busy && !queue_.is_idle()) return;
    view_.state = resting_state_;
    if (const auto wish = std::exchange(wished_, std::nullopt)) return reshape(*wish);
    if (wishes_turn_) return turn_again();
    // A core that is silent for a moment still has its job.
    const bool is_there = machine.status && machine.life != CoreLife::none;
    const std::uint64_t accepted = is_there ? machine.status->job_generation : 0;
    if (job_ && generation_ != 0 && accepted == generation_) view_.state = OpenJobState::published;
    view_.can_be_sliced = mesh_ != nullptr || table_way_;
    view_.was_published = job_ && generation_ != 0;
    view_.layer_count = job_ ? job_->view.layer_count() : 0;
    accepted_generation_ = accepted;
    compare_profiles(machine);
    view_.is_of_checkpoint = is_of_checkpoint(machine);
    view_.core_layer_count = core_job() ? core_job()->view.layer_count() : 0;
    // The segment of a dead core still has the job, which shows what the core was carving.
    const std::uint64_t left = machine.status ? machine.status->job_generation : 0;
    if (left != 0 && left != fetched_generation_ && queue_.is_idle()) fetch_from_core(left);
}

/// Makes the checksum only when it is needed: a large job takes a while.
bool OpenJob::is_of_checkpoint(const MachineView& machine) {
    const bool is_known = place_to_go_on(machine) || machine.earlier_layer;
    if (machine.is_heard() || !is_known || !job_ ||
        job_->view.layer_count() != machine.checkpoint_layer_count)
        return false;
    if (summed_job_ != job_) job_sum_ = job_checksum(job_->blob);
    summed_job_ = job_;
    return job_sum_ == machine.checkpoint_job_checksum;
}

/// Compares only when one of them has changed: not thirty times a second.
void OpenJob::compare_profiles(const MachineView& machine) {
    const std::uint64_t hash = machine.profile ? machine.core_profile_hash : 0;
    const JobPointer job = job_ ? job_ : core_job();
    if (compared_job_ == job && compared_hash_ == hash) return;
    compared_job_ = job;
    compared_hash_ = hash;
    view_.profile_difference.clear();
    view_.blank_difference.reset();
    if (!job || !machine.profile) return;
    view_.blank_difference = blank_difference(job->profile.blank, machine.profile->blank);
    const auto differences = job_differences(job->profile, *machine.profile);
    if (!differences.empty()) view_.profile_difference = differences.front();
}

}  // namespace psicarve::session
