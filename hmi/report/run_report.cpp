// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/run_report.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "hmi/report/exit_code.hpp"
#include "hmi/report/status_json.hpp"
#include "shared/base/units.hpp"

namespace psicarve::report {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

template <typename Values>
Json by_axis(const Values& values) {
    Json object;
    for (const Axis axis : kAllAxes) object[std::string{name_of(axis)}] = values[index_of(axis)];
    return object;
}

/// The simulated machine counts as long as its core lives; a report needs the counts of one run.
std::array<std::uint64_t, kAxisCount> since_start(const std::uint64_t* before, const std::uint64_t* last) {
    std::array<std::uint64_t, kAxisCount> counts{};
    for (std::size_t i = 0; i < kAxisCount; ++i) counts[i] = last[i] - std::min(before[i], last[i]);
    return counts;
}

void read_slice_report(const JobView& job, RunReport& report) {
    const Json slice = Json::parse(job.report_json(), nullptr, false);
    if (!slice.is_object()) return;
    if (const auto share = slice.find("undercut_share"); share != slice.end() && share->is_number()) {
        report.undercut_share = share->get<double>();
    }
    if (const auto open = slice.find("open_points"); open != slice.end() && open->is_number_unsigned()) {
        report.open_points = open->get<std::uint64_t>();
    }
}

Json alarms_json(const RunReport& report) {
    auto alarms = Json::array();
    for (const AlarmRecord& alarm : report.figures.alarms) alarms.push_back(alarm_json(alarm, report.table));
    return alarms;
}

/// ", stands -0.120 mm off": the simulated machine's true position of an axis minus the core's count; empty
/// where they agree.
std::string off_text(const CoreStatus& status, const Profile& profile, Axis axis) {
    const std::size_t k = index_of(axis);
    // Values in the segment may be anything.
    auto off_pulses =
        static_cast<std::int64_t>(static_cast<std::uint64_t>(status.sim_true_position_pulses[k]) -
                                  static_cast<std::uint64_t>(status.position_pulses[k]));
    if (axis == Axis::psi) {
        // Whole turns do not count.
        const std::int64_t turn = profile.psi.pulses_per_rev;
        off_pulses %= turn;
        if (off_pulses > turn / 2) off_pulses -= turn;
        if (off_pulses < -turn / 2) off_pulses += turn;
    }
    if (off_pulses == 0) return {};
    char text[64];
    if (axis == Axis::psi) {
        const double off_deg = deg_from_pulses(off_pulses, profile.psi.pulses_per_rev);
        std::snprintf(text, sizeof text, ", stands %+.3f degrees off", off_deg);
    } else {
        const double off_mm = mm_from_pulses(off_pulses, axis_motion(profile, axis).pulses_per_unit);
        std::snprintf(text, sizeof text, ", stands %+.3f mm off", off_mm);
    }
    return text;
}

/// Pulses that left the pins and did not move the simulated machine, and how far its axes are off since: the
/// pins may be right and the piece ruined.
std::string lost_steps_text(const CoreStatus& before, const CoreStatus& after,
                            const Result<Profile>& profile) {
    std::string text;
    const auto add = [&](Axis axis, const char* what, const std::uint64_t* was, const std::uint64_t* is) {
        const std::uint64_t count = since_start(was, is)[index_of(axis)];
        if (count == 0) return;
        text += (text.empty() ? "" : ", ") + std::string{name_of(axis)} + ' ' + what + ' ' +
                std::to_string(count);
    };
    for (const Axis axis : kAllAxes) {
        const std::size_t told = text.size();
        add(axis, "stalls", before.sim_stalls, after.sim_stalls);
        add(axis, "pulses against the driver's timing", before.sim_timing_lost, after.sim_timing_lost);
        add(axis, "pulses while disabled", before.sim_ignored_pulses, after.sim_ignored_pulses);
        if (text.size() > told && profile) text += off_text(after, *profile, axis);
    }
    return text;
}

}  // namespace

std::string difference_text(const verify::VerifyReport& seen) {
    const verify::Offence* first = seen.first_offence();
    return first != nullptr ? first->sentence : "not every point was visited";
}

std::optional<bool> is_verified(const RunReport& report) {
    if (!report.verification) return std::nullopt;
    return report.verification->ok && report.lost_steps.empty();
}

RunReport report_of(const JobView& job, const machine::JobRun& run) {
    RunReport report;
    report.source_name = job.source_name();
    report.layer_count = job.layer_count();
    report.point_count = job.point_count();
    report.figures = machine::figures_of(run);
    report.reference_seconds = report.figures.reference_seconds;
    report.has_started = run.has_started;
    report.wall_seconds = run.wall_seconds;
    report.failure = run.failure;
    report.before = run.before;
    report.last = run.after;
    const auto profile = job_profile(job);
    report.lost_steps = lost_steps_text(run.before, run.after, profile);
    if (profile) report.table = TableSize::of(*profile);
    read_slice_report(job, report);
    return report;
}

std::optional<Error> verdict_of(const RunReport& report) {
    if (report.failure) return report.failure;
    if (!report.lost_steps.empty()) {
        return Error{ErrorCode::difference_found,
                     "the simulated machine lost steps: " + report.lost_steps +
                         "; the profile asks for more than its motors or drivers can do"};
    }
    if (!report.verification || report.verification->ok) return std::nullopt;
    return Error{ErrorCode::difference_found,
                 "verification found a difference: " + difference_text(*report.verification)};
}

int run_exit_code(const RunReport& report, const Error& error) {
    const int exit_code = exit_code_of(error.code);
    return report.has_started && exit_code == kExitBadInput ? kExitMachine : exit_code;
}

std::string run_json(const RunReport& report) {
    const machine::RunFigures& figures = report.figures;
    Json object{
        {"source", report.source_name},
        {"layers", report.layer_count},
        {"points", report.point_count},
        {"pulses", by_axis(figures.pulses)},
        {"carve_seconds", or_null(figures.carve_seconds)},
        {"total_seconds", figures.total_seconds},
        {"reference_seconds", or_null(report.reference_seconds)},
        {"wall_seconds", report.wall_seconds},
        {"ticks", figures.ticks},
        {"missed_ticks", figures.missed_ticks},
        {"alarms", alarms_json(report)},
        {"verified", or_null(is_verified(report))},
        {"max_deviation_pulses",
         report.verification ? Json(report.verification->max_deviation_pulses) : Json(nullptr)},
        {"undercut_share", or_null(report.undercut_share)},
        {"open_points", or_null(report.open_points)},
        {"state", std::string{name_of(report.last.state)}},
        {"sim_stalls", by_axis(since_start(report.before.sim_stalls, report.last.sim_stalls))},
        {"sim_timing_lost", by_axis(since_start(report.before.sim_timing_lost, report.last.sim_timing_lost))},
        {"sim_ignored_pulses",
         by_axis(since_start(report.before.sim_ignored_pulses, report.last.sim_ignored_pulses))}};
    if (!report.verification && !report.unverified_reason.empty())
        object["unverified_reason"] = report.unverified_reason;
    if (report.verification) object["verification"] = Json::parse(verify::report_json(*report.verification));
    if (report.verification) {
        for (const verify::PassTime& pass : report.verification->passes)
            object["passes"].push_back(
                {{"pass", pass.name}, {"layers", pass.layers}, {"seconds", pass.seconds}});
    }
    if (!report.picture_path.empty()) object["picture"] = report.picture_path;
    if (!report.piece_path.empty()) object["piece"] = report.piece_path;
    if (!report.deviation_path.empty()) object["deviation_picture"] = report.deviation_path;
    if (report.deviation) object["deviation"] = Json::parse(piece::deviation_json(*report.deviation));
    if (const auto error = verdict_of(report))
        object["error"] = Json::parse(error_json(*error, run_exit_code(report, *error)));
    return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace psicarve::report
