// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/supervisor.hpp"

#include <optional>
#include <vector>

#include "rtcore/realtime/clock.hpp"
#include "shared/base/shared_text.hpp"
#include "shared/computer/event.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/machine/recording.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::milliseconds kSegmentCheckInterval{50};
/// More than a look's own length (rtcore::slept_ns), less than any sleep.
constexpr std::int64_t kLeastSleep_ns = 100'000'000;

/// No job runs, but the tick is busy: what is published waits until it is at rest.
bool must_wait_with_job(MachineState state) noexcept {
    return state == MachineState::homing || state == MachineState::moving ||
           state == MachineState::backing_off || state == MachineState::testing;
}

bool may_load_job(MachineState state) noexcept {
    return state == MachineState::off || state == MachineState::ready || state == MachineState::alarm;
}

std::int64_t first_sleep_ns() {
    std::optional<std::int64_t> slept;
    while (!slept) slept = rtcore::slept_ns();
    return *slept;
}

}  // namespace

Supervisor::Supervisor(CoreParts& parts, const SegmentOptions& segment_options, Segment segment,
                       const CoreFacts& facts)
    : parts_(&parts),
      segment_options_(segment_options),
      segment_(std::make_shared<Segment>(std::move(segment))),
      listener_(segment_, parts.io->urgent),
      server_(parts.profile, listener_, piece_, facts.is_virtual_clock),
      mirror_(facts),
      piece_({parts.state_folder, segment_options.name, facts.is_simulator, profile_hash(parts.profile)}),
      journal_({{parts.state_folder, segment_options.name, facts.is_simulator},
                profile_hash(parts.profile),
                parts.port_name,
                facts.is_virtual_clock}),
      is_virtual_clock_(facts.is_virtual_clock),
      promptness_(!facts.is_virtual_clock),
      sample_(read_sample()),
      judged_generation_(0),
      loader_(parts.profile, !facts.is_virtual_clock),
      layer_times_(parts.planned_files, parts.files),
      slept_ns_(first_sleep_ns()) {
    introduce();
    parts.traces.set_recording_taker([this](std::uint32_t token, std::span<const std::uint8_t> bytes) {
        recording_.put(segment_->header(), token, bytes, std::chrono::steady_clock::now());
    });
    server_.set_answer_taker(
        [this](const ReceivedCommand& received, AnswerKind kind, const Message& message) {
            journal_.note_answer(received, kind, message, sample_.tick);
        });
    publish_status();
}

void Supervisor::introduce() {
    piece_.enter(segment_->header());
    PortName port{};
    text_into_field(port.text, parts_->port_name);
    write_record(segment_->header().port, port);
    segment_->header().core_profile_hash.store(profile_hash(parts_->profile));
}

void Supervisor::set_program_access(ProgramAccess access) {
    programs_ = std::move(access);
    if (!programs_.open) return;
    server_.set_program_opener([this](std::uint64_t program) { return open_program(program); });
    server_.set_opened_taker([this](std::uint64_t program, bool is_done) {
        if (programs_.note_answer) programs_.note_answer(program, is_done);
    });
}

Result<void> Supervisor::open_program(std::uint64_t program) {
    auto source = programs_.open(program);
    if (!source) return source.error();
    parts_->planner->set_source(std::move(*source), program);
    return {};
}

bool Supervisor::poll(Hearing hearing) {
    const std::uint32_t wake_count = event_count(segment_->header().command_raised);
    const bool takes_requests = hearing == Hearing::everything;
    sample_ = read_sample();
    // What was asked for first; everything else may take its time.
    bool handed_on = listener_.look();
    if (takes_requests) handed_on = take_requests() || handed_on;
    promptness_.lower();
    check_segment();
    watch_guard();
    watch_sleep();
    journal_.note_program(*segment_, sample_);
    drain_reports();
    drain_increments();
    watch_recording();
    note_checkpoint();
    journal_.note_round(sample_);
    publish_status();
    // Who raised something that was not taken wakes us at once.
    if (takes_requests) wake_seen_ = server_.has_more() ? wake_count - 1 : wake_count;
    return handed_on;
}

bool Supervisor::take_requests() {
    // A jog that has begun since the look before is judged by its own lease.
    drain_reports();
    mirror_jog_lease();
    const std::size_t requests_before = parts_->io->requests.size();
    take_job();
    const LoadedJob* const job = loading_job_ != nullptr ? loading_job_.get() : job_.get();
    server_.note_seen(seen_generation_);
    server_.take_commands(*segment_, parts_->io->requests, sample_, job);
    return parts_->io->requests.size() > requests_before;
}

void Supervisor::wait(std::chrono::nanoseconds limit) noexcept {
    promptness_.raise();
    event_wait_past(segment_->header().command_raised, wake_seen_, limit);
}

bool Supervisor::request(cycle::RequestKind kind, std::uint64_t value, std::uint8_t axis) {
    cycle::Request request{};
    request.sequence = kOwnRequest;
    request.kind = kind;
    request.axis = axis;
    request.value = value;
    return parts_->io->requests.push(request);
}

// On the virtual clock ticks say nothing about how long a client has been silent: there the lease runs here.
void Supervisor::mirror_jog_lease() {
    const std::uint64_t word = segment_->header().jog_lease.load(std::memory_order_acquire);
    const bool is_renewed = word != parts_->io->urgent.jog_lease.load(std::memory_order_relaxed) &&
                            jog_lease_token(word) == server_.jog_token();
    const bool is_leased = sample_.state == MachineState::moving || sample_.state == MachineState::testing;
    if (!is_virtual_clock_ || !is_leased || is_renewed) {
        jog_renewed_ = std::chrono::steady_clock::now();
    }
    parts_->io->urgent.jog_lease.store(word, std::memory_order_release);
    if (!is_virtual_clock_ || server_.jog_lease().count() == 0) return;
    if (std::chrono::steady_clock::now() - jog_renewed_ < server_.jog_lease()) return;
    if (request(cycle::RequestKind::end_jog, static_cast<std::uint64_t>(MoveEnd::lease_gone)))
        jog_renewed_ = std::chrono::steady_clock::now();
}

void Supervisor::take_job() {
    // One at a time, and never while a request is on its way: a start must find the job it was given for.
    if (loading_job_ != nullptr || parts_->io->requests.size() > 0 || must_wait_with_job(sample_.state))
        return;
    if (!loader_.is_busy()) {
        const std::uint64_t generation = published_generation(*segment_);
        if (generation == 0 || generation == seen_generation_) return;
        if (generation <= judged_generation_) {
            // One after it was refused and taken back.
            seen_generation_ = generation;
            return;
        }
        // As long as its tables are, where there is no other thread for it.
        promptness_.lower();
        is_look_stale_ = false;
        loader_.begin(segment_, judged_generation_, generation);
    }
    if (auto outcome = loader_.take_outcome()) judge_job(std::move(*outcome));
}

void Supervisor::judge_job(JobLoader::Outcome outcome) {
    if (outcome.generation == 0 || is_look_stale_) return;
    seen_generation_ = outcome.generation;
    // A damaged word may be any number: publishers go on from the last good one.
    if (outcome.is_published) judged_generation_ = outcome.generation;
    if (!may_load_job(sample_.state)) {
        outcome.job = nullptr;
        outcome.refusal = message_of(MessageId::job_runs, argument_of(sample_.state));
    }
    if (outcome.job == nullptr) {
        journal_.note_refused_job(outcome.refusal, sample_.tick);
        acknowledge_job(*segment_, outcome.generation, false, {outcome.refusal});
    } else {
        offer_job(std::move(outcome.job));
    }
}

void Supervisor::offer_job(std::shared_ptr<const LoadedJob> job) {
    loading_job_ = std::move(job);
    is_offer_stale_ = false;
    hand_out(loading_job_);
    cycle::Request request{};
    request.sequence = kJobRequest;
    request.kind = cycle::RequestKind::job_loaded;
    request.value = loading_job_->generation;
    request.points_total = std::uint64_t{loading_job_->view.layer_count()} * loading_job_->view.point_count();
    request.points_per_layer = loading_job_->view.point_count();
    request.runs_back = loading_job_->view.joining() == Joining::zigzag ? 1 : 0;
    parts_->io->requests.push(request);
}

/// To all who work with a job that is started.
void Supervisor::hand_out(const std::shared_ptr<const LoadedJob>& job) {
    parts_->planner->set_job(std::shared_ptr<const JobView>{job, &job->view}, job->generation);
    parts_->traces.set_job({job, job->blob, job->checksum, job->generation});
}

void Supervisor::finish_job(const cycle::Report& report) {
    const bool accepted = report.refusal == cycle::Refusal::none;
    const std::uint64_t generation = loading_job_->generation;
    std::vector<Message> said;
    if (!accepted) said.push_back(message_of(MessageId::busy_for_a_job));
    if (accepted) {
        job_ = std::move(loading_job_);
        journal_.note_job(*job_, sample_.tick);
        if (!job_->remark.is_none()) said.push_back(job_->remark);
        const std::vector<Message> of_piece = piece_.take_job(segment_->header(), job_);
        said.insert(said.end(), of_piece.begin(), of_piece.end());
        if (parts_->estimator != nullptr)
            parts_->estimator->begin(std::shared_ptr<const JobView>{job_, &job_->view});
    } else if (job_ != nullptr) {
        hand_out(job_);
    }
    loading_job_.reset();
    // A reader that comes once the job is acknowledged must not find the times of the job before.
    publish_status();
    // The segment that it came from is gone: in the new one it was not asked for.
    if (!is_offer_stale_) acknowledge_job(*segment_, generation, accepted, said);
}

cycle::Sample Supervisor::read_sample() const {
    // On the virtual clock the tick runs in this very thread, and may rest for long with its record not
    // renewed.
    cycle::Sample sample = is_virtual_clock_ ? parts_->cycle->sample() : parts_->io->sample.read();
    sample.trace_lost += parts_->traces.lost();
    return sample;
}

void Supervisor::drain_reports() {
    while (const cycle::Report* next = parts_->io->reports.front()) {
        const cycle::Report report = *next;
        sample_ = read_sample();
        // A client must see the state that its request led to no later than the answer: the sample of
        // that tick is written at its end. It comes; the next round will find it.
        if (report.kind == cycle::Report::Kind::answer && sample_.tick < report.record.tick) return;
        parts_->io->reports.pop();
        const FlightRecord& record = report.record;
        if (record.kind != RecordKind::none) flight_log_.append(segment_->header().recorder, record);
        if (record.kind == RecordKind::alarm) mirror_.note_alarm(report);
        if (record.kind == RecordKind::alarm || record.kind == RecordKind::state_change) ++changes_;
        journal_.note_program(*segment_, sample_);
        journal_.note_report(report, sample_, job_.get());
        if (report.kind != cycle::Report::Kind::answer) continue;
        if (report.sequence == kOwnRequest) continue;
        if (report.sequence == kJobRequest) {
            if (loading_job_ != nullptr) finish_job(report);
        } else {
            publish_status();
            server_.deliver_answer(*segment_, report, sample_);
        }
    }
}

void Supervisor::drain_increments() {
    IncrementEntry entry;
    while (parts_->io->increments.pop_into(entry)) append_to_ring(segment_->header().increments, entry);
}

void Supervisor::watch_recording() {
    if (recording_.is_abandoned(segment_->header(), std::chrono::steady_clock::now())) {
        parts_->traces.drop_recording();
        must_end_recording_ = true;
    }
    if (must_end_recording_ &&
        request(cycle::RequestKind::record, static_cast<std::uint64_t>(RecordingForm::none)))
        must_end_recording_ = false;
}

void Supervisor::note_checkpoint() {
    piece_.note(segment_->header(), sample_, job_);
}

PlannedTimes Supervisor::planned_times() {
    // The tick may have a job that the estimator has not been given yet.
    if (job_ != nullptr && job_->generation != sample_.job_generation)
        return {.left_s = -1.0, .reference_s = -1.0};
    std::shared_ptr<const plan::JobEstimate> estimate;
    PlannedTimes times{.left_s = -1.0, .reference_s = parts_->planner->reference_seconds()};
    if (parts_->estimator != nullptr) {
        estimate = parts_->estimator->estimate();
        const plan::TimeLeft left =
            parts_->estimator->left(sample_.points_done, parts_->planner->points_total());
        // At rest it is the whole job that is told of, once it is planned.
        if (runs_job(sample_.state) && sample_.program.is_running == 0) {
            times.left_s = left.seconds;
            times.is_left_forecast = left.seconds >= 0.0 && !left.is_planned;
        }
    }
    // Before the status tells that the job is planned.
    if (!layer_times_.tell(estimate, job_)) return {.left_s = -1.0, .reference_s = -1.0};
    if (estimate == nullptr) return times;
    if (!runs_job(sample_.state)) times.left_s = estimate->seconds();
    if (times.reference_s < 0.0 && estimate->is_reference()) times.reference_s = estimate->seconds();
    return times;
}

void Supervisor::publish_status() {
    if (parts_->machine != nullptr && !is_machine_frozen_) mirror_.set_sim(sim_facts(*parts_->machine));
    if (programs_.serve) programs_.serve(segment_, sample_.program);
    write_record(segment_->header().status, mirror_.compose(sample_, planned_times()));
    if (changes_ != changes_told_) {
        changes_told_ = changes_;
        event_signal(segment_->header().status_changed);
    }
}

void Supervisor::watch_guard() {
    if (parts_->guard == nullptr) return;
    // For ever: without it nothing moves any more, even if the alarm is reset.
    const bool is_lost = parts_->guard->is_guard_lost(std::chrono::steady_clock::now());
    server_.keep_in_alarm(is_lost);
    if (sample_.state == MachineState::alarm) {
        is_guard_lost_told_ = false;
    } else if (is_lost && !is_guard_lost_told_) {
        is_guard_lost_told_ = true;
        fail(cycle::failure_bits(AlarmCause::guard_lost));
    }
}

// No program sees its time go by, the tick least of all; but drives and port had no power meanwhile.
void Supervisor::watch_sleep() {
    if (is_virtual_clock_) return;
    const auto slept = rtcore::slept_ns();
    if (!slept || *slept - slept_ns_ < kLeastSleep_ns) return;
    constexpr std::uint8_t kAllAxes_mask = 0xF;
    slept_ns_ = *slept;
    fail(cycle::failure_bits(AlarmCause::tick_gap, kAllAxes_mask));
}

void Supervisor::check_segment() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_segment_check_) return;
    next_segment_check_ = now + kSegmentCheckInterval;
    if (!is_segment_lost_ && segment_->is_still_linked()) return;
    if (!is_segment_lost_) {
        is_segment_lost_ = true;
        fail(cycle::failure_bits(AlarmCause::segment_lost));
    }
    take_new_segment();
}

void Supervisor::take_new_segment() {
    // What we served is ours to replace, truncated or overwritten as it is; so is garbage in its place.
    // Anything else may be in use; we ask again.
    if (!segment_->give_up_name()) return;
    SegmentOptions options = segment_options_;
    options.replaces_damaged = true;
    options.patience = std::chrono::milliseconds{5};  // we come round again
    auto fresh = Segment::create_or_attach(options);
    if (!fresh) return;
    if (!fresh->claim_core() || !fresh->fit_rights(options.group)) return;
    server_.forget_all();
    flight_log_.begin_anew();
    segment_ = std::make_shared<Segment>(std::move(*fresh));
    introduce();
    listener_.turn_to(segment_);
    judged_generation_ = 0;
    seen_generation_ = 0;
    is_look_stale_ = true;
    is_offer_stale_ = true;
    piece_.write_anew(segment_->header());
    is_segment_lost_ = false;
}

void Supervisor::leave() {
    sample_ = read_sample();
    drain_reports();
    drain_increments();
    note_checkpoint();
    publish_status();
    // Before the next core may come: that one reads how this one ended.
    journal_.note_end(sample_);
    event_signal(segment_->header().status_changed);
    segment_->release_core();
}

}  // namespace psicarve::supervisor
