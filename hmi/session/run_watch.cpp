// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/run_watch.hpp"

#include <string>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/display_text.hpp"

namespace psicarve::session {
namespace {

Phrase how_it_went(const machine::RunFigures& figures, const CoreStatus& after, bool is_over,
                   std::uint32_t layer_count) {
    if (!is_over) return phrase("under way");
    if (!figures.alarms.empty()) return phrase("ended by an alarm");
    if (figures.is_complete && after.is_dry != 0)
        return phrase("dry run to the last point: nothing was carved");
    if (figures.is_complete) return phrase("carved to the last point");
    return phrase("ended at layer %1 of %2", std::to_string(after.layer + 1), std::to_string(layer_count));
}

Phrase time_or_none(const std::optional<double>& seconds) {
    return seconds ? phrase("%1", clock_text(*seconds)) : phrase("not known");
}

}  // namespace

void RunWatch::note(const MachineView& machine, Clock::time_point now) {
    if (!machine.status || !machine.is_heard()) return;
    const CoreStatus& status = *machine.status;
    if (machine.core_pid != core_pid_) {
        core_pid_ = machine.core_pid;
        run_.reset();
        last_.reset();
    }
    const std::uint64_t seen_start = run_ ? run_->after.job_start_tick : 0;
    if (status.job_start_tick != 0 && status.job_start_tick != seen_start) begin(status, now);
    if (run_ && !is_over_) {
        run_->after = status;
        run_->wall_seconds = std::chrono::duration<double>(now - began_).count();
        is_over_ = !machine.runs_job();
    }
    last_ = status;
}

void RunWatch::begin(const CoreStatus& status, Clock::time_point now) {
    run_.emplace();
    run_->has_started = true;
    // The run began before the window looked: its earlier counts cannot be told from later ones.
    seen_from_layer_ = last_ || status.points_done == 0 ? std::nullopt : std::optional{status.layer};
    run_->before = last_.value_or(status);
    run_->before.tick = status.job_start_tick;
    is_over_ = false;
    began_ = now;
}

std::vector<ReportRow> run_rows(const machine::JobRun& run, bool is_over, std::uint32_t layer_count,
                                std::optional<bool> is_verified,
                                std::optional<std::uint32_t> seen_from_layer) {
    const machine::RunFigures figures = machine::figures_of(run);
    std::vector<ReportRow> rows{{phrase("Result"), how_it_went(figures, run.after, is_over, layer_count)},
                                {phrase("Carving time"), time_or_none(figures.carve_seconds)},
                                {phrase("Total time"), phrase("%1", clock_text(figures.total_seconds))},
                                {phrase("Reference time (T_ref)"), time_or_none(figures.reference_seconds)}};
    for (const Axis axis : kAllAxes) {
        rows.push_back({phrase("Pulses of %1, with the ways in and out", axis_letter(axis)),
                        phrase("%1", count_text(static_cast<std::int64_t>(figures.pulses[index_of(axis)])))});
    }
    const auto count_row = [&](Phrase name, std::uint64_t count) {
        rows.push_back({std::move(name), seen_from_layer
                                             ? phrase("%1 since layer %2, when this window came",
                                                      counted(count), std::to_string(*seen_from_layer + 1))
                                             : phrase("%1", counted(count))});
    };
    count_row(phrase("Missed ticks"), figures.missed_ticks);
    count_row(phrase("Alarms"), figures.alarms.size());
    rows.push_back({phrase("Verified"), run.after.is_dry != 0 ? phrase("no: a dry run carves nothing")
                                        : !is_verified ? phrase("no: its pins were not recorded (page Ports)")
                                        : *is_verified ? phrase("yes")
                                                       : phrase("NO")});
    return rows;
}

}  // namespace psicarve::session
