// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/pin_recorder.hpp"

#include <utility>

#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/recorded_pins.hpp"
#include "hmi/phrase/message_phrase.hpp"
#include "hmi/session/action_lock.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/recorded_start.hpp"
#include "shared/segment/layout.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::session {

/// The data of one recording; the pins refer to the link and to the job.
struct PinRecorder::Taken {
    Taken(machine::MachineLink machine, JobPointer carved)
        : link(std::move(machine)), job(std::move(carved)), records(link.segment().header().recorder, true) {}
    machine::MachineLink link;
    JobPointer job;
    std::unique_ptr<machine::RecordedPins> pins;
    RingReader<FlightRecord, kFlightRecords> records;  ///< of the recording
};

PinRecorder::PinRecorder(std::string segment_name, std::string group, MessageLog& log, PendingSaves saves)
    : segment_name_(std::move(segment_name)), group_(std::move(group)), log_(log), saves_(std::move(saves)) {}

PinRecorder::~PinRecorder() {
    // Ends a recording here, so that its file is whole; one that is ending gets its time.
    if (state_ == State::ending) queue_.finish();
    queue_.drop_waiting();
    if (!taken_ || !taken_->pins || state_ != State::recording) return;
    const PendingSaves::Entry save = saves_.begin(path_);
    (void)taken_->pins->finish();
}

void PinRecorder::begin(const std::string& path, const JobPointer& job) {
    if (state_ != State::idle || !job) return;
    state_ = State::starting;
    ends_once_begun_ = false;
    path_ = path;
    queue_.post([this, path, job, segment = segment_name_, group = group_]() -> BackgroundQueue::Finish {
        auto link = machine::MachineLink::attach(segment, group);
        if (!link) {
            return [this, why = link.error()] {
                state_ = State::idle;
                log_.add(Severity::warning, refusal_phrase(phrase("Record pins"), why));
            };
        }
        auto taken = std::make_shared<Taken>(std::move(*link), job);
        auto pins = machine::RecordedPins::start(taken->link, job->view, job->profile, path, {},
                                                 machine::RecordedPins::FileJob::left_out);
        if (!pins) {
            return [this, why = pins.error()] {
                state_ = State::idle;
                log_.add(Severity::warning, refusal_phrase(phrase("Record pins"), why));
            };
        }
        taken->pins = std::move(*pins);
        return [this, taken] {
            taken_ = taken;
            state_ = State::recording;
            // The record of a run before this recording. A clock that stands at rest does not order before
            // and after.
            run_start_tick_ = last_ ? last_->job_start_tick : 0;
            runs_ = 0;
            is_one_whole_run_ = false;
            log_.add(Severity::info, phrase("Recording the pins: %1", path_));
            if (ends_once_begun_) end();
        };
    });
}

void PinRecorder::end() {
    if (state_ == State::starting) ends_once_begun_ = true;
    if (state_ != State::recording) return;
    state_ = State::ending;
    // Threads of the recording write the file's end; the queue waits for them here.
    queue_.post([this, taken = taken_, save = saves_.begin(path_)]() -> BackgroundQueue::Finish {
        const auto report = taken->pins->finish();
        const auto no_file = taken->pins->trace_failure();
        taken->pins.reset();
        return [this, report, no_file] {
            taken_.reset();
            state_ = State::idle;
            tell(report, no_file);
        };
    });
}

void PinRecorder::tell(const Result<verify::VerifyReport>& report, std::optional<Error> no_file) {
    if (no_file) {
        log_.add(Severity::warning, refusal_phrase(phrase("Record pins"), *no_file));
    } else if (report) {
        log_.add(Severity::info, phrase("Pins recorded: %1", path_));
    }
    verdict_.reset();
    if (!report || !is_one_whole_run_) return;
    verdict_ = *report;
    judged_start_tick_ = run_start_tick_;
    const verify::Offence* const first = report->first_offence();
    if (report->ok) {
        log_.add(Severity::info, phrase("Verified: the pins carve the job, largest deviation %1 pulses",
                                        std::to_string(report->max_deviation_pulses)));
    } else {
        log_.add(Severity::warning,
                 phrase("Verification found a difference: %1",
                        first != nullptr ? first->sentence : "not every point was visited"));
    }
}

void PinRecorder::poll(const MachineView& machine) {
    queue_.deliver();
    if (machine.status) last_ = machine.status;
    if (state_ != State::recording || !last_) return;
    const CoreStatus& now = *last_;
    if (now.job_start_tick != run_start_tick_) {
        const auto is_whole = began_whole(now.job_start_tick);
        if (!is_whole) return;  // a short run may be over by now: the next call looks at it
        // A second run, one that leaves out layers, or a dry one is not the whole job.
        is_one_whole_run_ = ++runs_ == 1 && *is_whole;
        run_start_tick_ = now.job_start_tick;
    }
    const bool is_over = runs_ != 0 && !machine.runs_job();
    if (!is_over) return;
    if (now.points_done != now.points_total || now.job_end_tick == 0) is_one_whole_run_ = false;
    if (is_one_whole_run_) end();  // the run is complete: no need to be asked
}

std::optional<bool> PinRecorder::began_whole(std::uint64_t start_tick) {
    while (const auto record = taken_->records.next()) {
        const bool is_start = record->kind == RecordKind::command &&
                              record->code == static_cast<std::uint16_t>(CommandKind::start) &&
                              record->answer == static_cast<std::uint32_t>(AnswerKind::done);
        if (!is_start || record->tick < start_tick) continue;
        const auto asked = static_cast<std::uint64_t>(record->value);
        return (asked & (kRecordedFirstLayer | kRecordedFirstPoint | kRecordedDryRun)) == 0;
    }
    return std::nullopt;
}

std::optional<verify::VerifyReport> PinRecorder::verdict_on(const machine::JobRun& run) const {
    if (!verdict_ || run.after.job_start_tick != judged_start_tick_) return std::nullopt;
    return verdict_;
}

std::optional<Phrase> record_lock(const MachineView& machine, bool has_core_job, PinRecorder::State state) {
    if (state == PinRecorder::State::recording || state == PinRecorder::State::starting) return std::nullopt;
    if (state == PinRecorder::State::ending)
        return phrase("Record pins: the last recording is being written");
    if (machine.life == CoreLife::none) return phrase("No core serves the segment");
    if (!machine.is_heard() || !machine.status) return phrase("The core is silent");
    if (!is_at_rest(machine.state())) return phrase("Record pins: begin it while the machine is at rest");
    if (!has_core_job) return phrase("Record pins: publish a job first");
    return std::nullopt;
}

}  // namespace psicarve::session
