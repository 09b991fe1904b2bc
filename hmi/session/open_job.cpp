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
    task_.is_cancelled.store(false);
    task_.progress_ratio.store(0.0);
}

void OpenJob::open(const std::string& path) {
    post_open(path, true);
}

void OpenJob::post_open(const std::string& path, bool may_be_recording) {
    if (view_.is_busy()) return;
    begin(OpenJobState::opening);
    refused_file_.reset();
    // The same file again gets the form's settings.
    const bool is_same = path == file_.path();
    const model::MeshTurn turn = is_same ? model_.turn : model::MeshTurn{};
    const std::optional<flat::FlatOptions> shape = is_same ? std::optional{model_.shape} : std::nullopt;
    queue_.post([this, path, may_be_recording, turn, shape, machine = hooks_.profile(),
                 way = hooks_.table_way()]() -> BackgroundQueue::Finish {
        if (may_be_recording && hooks_.is_recording && hooks_.is_recording(path))
            return [this, path] { hooks_.take_recording(path); };
        const auto stamp = FileWatch::stamp_of(path);
        const auto opened = std::make_shared<OpenedFile>(read_opened(path, machine, shape, turn, way));
        opened->stamp = stamp;
        return [this, path, way, opened] { take_opened(path, way, std::move(*opened)); };
    });
}

void OpenJob::reshape(const flat::FlatOptions& options) {
    if (file_.path().empty() || model_.kind == flat::ModelKind::mesh) return;
    model_.wished_shape = options;
    model_.shape = options;
    if (view_.is_busy()) return;  // poll() comes back to it
    model_.wished_shape.reset();
    begin(OpenJobState::opening);
    queue_.post([this, path = file_.path(), options, turn = model_.turn]() -> BackgroundQueue::Finish {
        const auto stamp = FileWatch::stamp_of(path);
        const auto opened = std::make_shared<OpenedFile>(read_opened_model(path, options, turn));
        opened->stamp = stamp;
        return [this, opened] {
            file_.watch(file_.path(), opened->stamp);
            take_body(std::move(*opened));
        };
    });
}

/// Another body of the same file, or none: never one that was not asked for.
void OpenJob::take_body(OpenedFile opened) {
    if (task_.is_cancelled.load()) {
        opened = {};
        opened.error = Error{ErrorCode::cancelled, file_.path() + ": opening was cancelled"};
    }
    if (opened.error) fail(*opened.error);
    model_.take_body(opened);
    drop_job();
    resting_state_ = model_.mesh ? OpenJobState::model : OpenJobState::empty;
    ++edition_;
}

void OpenJob::turn(const model::MeshTurn& turn) {
    if (turn == model_.turn) return;
    model_.turn = turn;
    model_.wishes_turn = true;
    if (!view_.is_busy()) turn_again();  // else poll() comes back to it
}

void OpenJob::turn_again() {
    model_.wishes_turn = false;
    if (!model_.file_mesh) return;
    begin(OpenJobState::opening);
    queue_.post([this, mesh = model_.file_mesh, turn = model_.turn]() -> BackgroundQueue::Finish {
        const auto opened = std::make_shared<OpenedFile>(turned_again(mesh, turn));
        return [this, opened] { take_body(std::move(*opened)); };
    });
}

void OpenJob::take_opened(const std::string& path, const TableWay& way, OpenedFile opened) {
    if (task_.is_cancelled.load())
        opened.error = Error{ErrorCode::cancelled, path + ": opening was cancelled"};
    const bool is_cancelled = task_.is_cancelled.load();
    // Lines that do not fit the default cylinder stay open, so that the user can choose another one.
    const bool is_refused = opened.error && !is_cancelled && !opened.is_line_art;
    if (is_refused) return refuse(path, error_phrase(*opened.error));
    if (opened.error) fail(*opened.error);
    if (is_cancelled) return;
    if (hooks_.opened) hooks_.opened();
    model_.take_file(opened, path != file_.path());
    desk_.table_way = opened.is_table ? std::optional{way} : std::nullopt;
    file_.watch(path, opened.stamp);
    drop_job();
    resting_state_ = model_.mesh || opened.job ? OpenJobState::model : OpenJobState::empty;
    const std::string name = std::filesystem::path{path}.filename().string();
    log_.add(Severity::info, phrase("Opened %1", name));
    if (opened.job) return take_job(std::move(opened.job), 0);
    ++edition_;
    if (opened.is_line_art)
        log_.add(Severity::warning, phrase("%1 has no closed outline: its lines are engraved", name));
    if (!model_.mesh) return;
    for (const std::string& warning : model_.mesh->warnings)
        log_.add(Severity::warning, warning_phrase(warning));
}

void OpenJob::note_change() {
    file_.poll(FileWatch::Clock::now());
    if (!file_.take_change()) return;
    log_.add(Severity::warning, phrase("%1 was written since it was opened: Reload takes it as it is now",
                                       std::filesystem::path{file_.path()}.filename().string()));
}

void OpenJob::slice(const cam::JobOptions& options, const Profile& profile) {
    if (view_.is_busy()) return;
    if (desk_.table_way) return make_table_job({profile, options.joining});
    if (!model_.mesh) return;
    begin(OpenJobState::slicing);
    cam::JobOptions how = options;
    const auto show = [this](double done) {
        task_.progress_ratio.store(done);
        return !task_.is_cancelled.load();
    };
    how.progress = show;
    how.search_progress = show;
    const bool is_mesh = model_.kind == flat::ModelKind::mesh;
    queue_.post([this, how, profile, is_mesh, mesh = model_.mesh]() -> BackgroundQueue::Finish {
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
    queue_.post([this, path = file_.path(), way = std::move(way)]() -> BackgroundQueue::Finish {
        const auto stamp = FileWatch::stamp_of(path);
        auto job = job_of_table(path, way);
        if (task_.is_cancelled.load()) job = Error{ErrorCode::cancelled, path + ": slicing was cancelled"};
        if (!job) {
            return [this, error = job.error()] { refuse_desk(OpenJobRefusal::Of::slicing, error, {}); };
        }
        return [this, way, stamp, made = *job] {
            desk_.table_way = way;
            file_.watch(file_.path(), stamp);
            take_job(made, 0);
        };
    });
}

void OpenJob::drop_job() {
    desk_.job.reset();
    desk_.mesh.reset();
}

void OpenJob::take_job(JobPointer job, std::uint64_t generation, MeshPointer mesh) {
    desk_.job = std::move(job);
    desk_.mesh = std::move(mesh);
    desk_.generation = generation;
    resting_state_ = OpenJobState::job;
    ++edition_;
    const auto known = desk_.mesh ? desk_.mesh->warnings : std::vector<std::string>{};
    for (const std::string& warning : other_warnings(desk_.job->warnings, known))
        log_.add(Severity::warning, warning_phrase(warning));
    for (const std::string& note : desk_.job->notes) log_.add(Severity::info, error_phrase(note));
    log_.add(Severity::info, phrase("Job: %1 × %2 points", std::to_string(desk_.job->view.layer_count()),
                                    std::to_string(desk_.job->view.point_count())));
}

void OpenJob::publish() {
    if (view_.is_busy() || !desk_.job) return;
    begin(OpenJobState::publishing);
    queue_.post([this, job = desk_.job, mesh = desk_.mesh, path = file_.path()]() -> BackgroundQueue::Finish {
        const auto generation = publish_and_wait(segment_name_, group_, *job, task_.is_cancelled);
        if (!generation) {
            return [this, error = generation.error()] {
                const bool is_sliceable = model_.mesh != nullptr || desk_.table_way;
                refuse_desk(OpenJobRefusal::Of::publishing, error,
                            is_sliceable ? publishing_remedies(error) : std::vector<Remedy>{});
            };
        }
        return [this, job, mesh, path, number = *generation] {
            desk_.generation = number;
            machine_job_.take_published(number, job, mesh, path);
            resting_state_ = OpenJobState::job;
        };
    });
}

void OpenJob::take_over(const cam::PreparedJob* saved) {
    if (!can_take_over()) return;
    const JobPointer job = core_job();
    // Its body may have been made anew since.
    const bool is_of_open = !machine_job_.path().empty() && machine_job_.path() == file_.path();
    if (!is_of_open) {
        tell_unkept(saved);
        close_file();
    }
    if (hooks_.opened) hooks_.opened();
    refusal_.reset();
    desk_.taken = job;
    log_.add(Severity::info, phrase("Taken over from the machine: %1", std::string{job->view.source_name()}));
    take_job(job, machine_job_.generation(), machine_job_.mesh());
}

/// A sliced job is not dropped without a message.
void OpenJob::tell_unkept(const cam::PreparedJob* saved) {
    const bool is_sliced = desk_.mesh != nullptr || desk_.table_way;
    if (!desk_.job || !is_sliced || desk_.generation != 0 || desk_.job.get() == saved) return;
    log_.add(Severity::warning,
             phrase("Closed: %1, neither published nor saved", std::string{desk_.job->view.source_name()}));
}

void OpenJob::close_file() {
    file_.watch({}, {});
    refused_file_.reset();
    model_ = {};
    desk_.table_way.reset();
    drop_job();
}

void OpenJob::fail(const Error& error) {
    const Severity severity = error.code == ErrorCode::cancelled ? Severity::info : Severity::warning;
    log_.add(severity, error_phrase(error));
}

void OpenJob::refuse_desk(OpenJobRefusal::Of of, const Error& error, std::vector<Remedy> remedies) {
    fail(error);
    if (error.code == ErrorCode::cancelled) return;
    const std::string name = model_.mesh ? model_.mesh->source_name : file_.path();
    refusal_ = {of, name, error_phrase(error), std::move(remedies)};
}

void OpenJob::fetch_from_core(std::uint64_t generation) {
    machine_job_.note_fetch(generation);
    queue_.post([this, generation]() -> BackgroundQueue::Finish {
        const auto job = job_in_segment(segment_name_, group_);
        if (!job) return [this, error = job.error()] { fail(error); };
        return [this, made = *job, generation] {
            machine_job_.take_fetched(generation, made);
            ++edition_;
            // A job that the user has taken over stays until they take another.
            if (!model_.mesh && file_.path().empty() && !is_taken_over()) take_job(made, generation);
        };
    });
}

void OpenJob::poll(const MachineView& machine) {
    const bool was_busy = view_.is_busy();
    queue_.deliver();
    note_change();
    if (was_busy && !queue_.is_idle()) return;
    view_.state = resting_state_;
    if (const auto wish = std::exchange(model_.wished_shape, std::nullopt)) return reshape(*wish);
    if (model_.wishes_turn) return turn_again();
    // A core that is silent for a moment still has its job.
    const bool is_there = machine.status && machine.life != CoreLife::none;
    const std::uint64_t accepted = is_there ? machine.status->job_generation : 0;
    if (desk_.job && desk_.generation != 0 && accepted == desk_.generation)
        view_.state = OpenJobState::published;
    view_.can_be_sliced = model_.mesh != nullptr || desk_.table_way;
    view_.was_published = desk_.job && desk_.generation != 0;
    view_.layer_count = desk_.job ? desk_.job->view.layer_count() : 0;
    machine_job_.note_accepted(accepted);
    comparison_.compare_profiles(desk_.job ? desk_.job : core_job(), machine, view_);
    view_.is_of_checkpoint = comparison_.is_of_checkpoint(desk_.job, machine);
    view_.core_layer_count = core_job() ? core_job()->view.layer_count() : 0;
    // The segment of a dead core still has the job, which shows what the core was carving.
    const std::uint64_t left = machine.status ? machine.status->job_generation : 0;
    if (machine_job_.is_to_be_fetched(left) && queue_.is_idle()) fetch_from_core(left);
}

}  // namespace psicarve::session
