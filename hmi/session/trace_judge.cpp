// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/trace_judge.hpp"

#include <filesystem>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/phrase/error_phrase.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/session/machine_view.hpp"
#include "hmi/trace/carried_job.hpp"
#include "shared/job/job.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::session {
namespace {

using JobPointer = std::shared_ptr<const cam::PreparedJob>;

/// The open job, if the trace carries it or no whole one; else the trace's only one.
Result<JobPointer> job_of(const std::string& path, const JobPointer& open_job) {
    if (open_job && verify::check_is_of_trace(path, job_checksum(open_job->blob), {})) return open_job;
    auto blob = verify::only_carried_job(path, "open the one that is meant");
    if (!blob) return blob.error();
    if (!*blob) return bad_input(path + ": carries no job; open its job first");
    Snapshot snapshot;
    snapshot.job_blob = std::move(**blob);
    auto job = cam::prepare_snapshot(std::move(snapshot), path);
    if (!job) return job.error();
    return JobPointer{std::make_shared<const cam::PreparedJob>(std::move(job).value())};
}

Result<std::shared_ptr<const Judgement>> judged(const std::string& path, const JobPointer& open_job,
                                                const verify::AskedCarving& asked,
                                                const std::atomic<bool>& cancels) {
    const auto own = job_of(path, open_job);
    if (!own) return own.error();
    const JobPointer& job = *own;
    const auto trace = verify::open_trace(path);
    if (!trace) return trace.error();
    auto verifier = verify::Verifier::make_for(job->view, job->profile, asked);
    if (!verifier) return verifier.error();
    auto kept = std::make_shared<verify::Verifier>(std::move(*verifier));
    auto report = verify::verify_trace(*kept, **trace, [&cancels] { return !cancels.load(); });
    if (!report) return report.error();
    return std::make_shared<const Judgement>(Judgement{path, job, std::move(*report), std::move(kept)});
}

/// Layers and points as the window counts them, from 1.
Phrase judged_part(const verify::VerifyReport& report) {
    if (report.is_dry) return phrase("the pulses of a dry run");
    if (report.is_whole_job)
        return report.is_cut ? phrase("the job from its begin") : phrase("the whole job");
    const std::string first = std::to_string(report.first_layer + 1);
    const std::string last = std::to_string(report.first_layer + report.layer_count);
    if (!report.first_point) return phrase("layers %1 to %2", first, last);
    return phrase("layers %1 to %2, from point %3 on", first, last, std::to_string(*report.first_point + 1));
}

Phrase deviation_phrase(const verify::VerifyReport& report) {
    if (report.carve_seconds == 0.0) return phrase("nothing was carved");
    const std::string pulses = count_text(report.max_deviation_pulses);
    return report.is_cut ? phrase("%1 pulses, of what was carved", pulses) : phrase("%1 pulses", pulses);
}

Phrase carve_time_phrase(const verify::VerifyReport& report) {
    if (report.carve_seconds == 0.0) return phrase("nothing was carved");
    const std::string time = clock_text(report.carve_seconds);
    return report.is_complete ? phrase("%1", time) : phrase("%1, not finished", time);
}

}  // namespace

void TraceJudge::judge(const std::string& path, std::shared_ptr<const cam::PreparedJob> job,
                       const verify::AskedCarving& asked) {
    if (is_judging_) return;
    is_judging_ = true;
    cancels_.store(false);
    log_.add(Severity::info, phrase("Verifying %1", std::filesystem::path{path}.filename().string()));
    queue_.post([this, path, job = std::move(job), asked]() -> BackgroundQueue::Finish {
        const auto judgement = judged(path, job, asked, cancels_);
        if (!judgement) {
            return [this, why = judgement.error()] {
                is_judging_ = false;
                const bool is_wish = why.code == ErrorCode::cancelled;
                log_.add(is_wish ? Severity::info : Severity::warning, error_phrase(why));
            };
        }
        return [this, open_job = job, done = *judgement] {
            is_judging_ = false;
            done_ = done;
            log_.add(Severity::info, done->job == open_job
                                         ? phrase("Judged by the job that is open")
                                         : phrase("Judged by the job that the trace carries"));
            const bool is_good = done->report.ok;
            log_.add(is_good ? Severity::info : Severity::warning,
                     is_good ? verified_phrase(done->report) : phrase("Verification found a difference"));
        };
    });
}

Phrase verified_phrase(const verify::VerifyReport& report) {
    if (report.is_dry) return phrase("Verified: the pulses of a dry run, which carves nothing");
    const std::string pulses = std::to_string(report.max_deviation_pulses);
    return report.is_cut ? phrase("Verified as far as it was recorded, largest deviation %1 pulses", pulses)
                         : phrase("Verified: the pins carve the job, largest deviation %1 pulses", pulses);
}

std::vector<VerdictRow> verdict_rows(const verify::VerifyReport& report) {
    const verify::Offence* const first = report.first_offence();
    std::vector<VerdictRow> rows{{phrase("Verified"), report.ok ? phrase("yes") : phrase("NO")},
                                 {phrase("Judged"), judged_part(report)}};
    if (report.is_cut) rows.push_back({phrase("Judged up to"), phrase("where it was recorded")});
    rows.insert(rows.end(),
                {{phrase("Points visited"),
                  phrase("%1 of %2", counted(report.points_visited), counted(report.points_total))},
                 {phrase("Largest deviation"), deviation_phrase(report)},
                 {phrase("Surface that no tip reached"), phrase("%1 cells", counted(report.uncarved_cells))},
                 {phrase("Carving time"), carve_time_phrase(report)}});
    for (const Axis axis : kAllAxes)
        rows.push_back({phrase("Pulses of %1", axis_letter(axis)),
                        phrase("%1", counted(report.pulses[index_of(axis)]))});
    if (first != nullptr) rows.push_back({phrase("First difference"), phrase("%1", first->sentence)});
    return rows;
}

}  // namespace psicarve::session
