// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/run_report.hpp"

#include <cstdio>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/report/lost_steps.hpp"

namespace psicarve::cli {
namespace {

template <typename... Args>
std::string formatted(const char* format, Args... args) {
    char text[256];
    std::snprintf(text, sizeof text, format, args...);
    return text;
}

std::string pulses_text(const std::array<std::uint64_t, kAxisCount>& pulses) {
    std::string text;
    for (const Axis axis : kAllAxes) {
        text += (text.empty() ? "" : ", ") + std::string{name_of(axis)} + " " +
                std::to_string(pulses[index_of(axis)]);
    }
    return text;
}

std::string alarms_text(const machine::RunFigures& figures) {
    std::string text;
    for (const AlarmRecord& alarm : figures.alarms) {
        text += (text.empty() ? "" : ", ") + std::string{name_of(alarm.cause)};
        if (alarm.axis < kAxisCount) text += " of " + std::string{name_of(static_cast<Axis>(alarm.axis))};
        text += " at tick " + std::to_string(alarm.tick);
    }
    return text.empty() ? "none" : text;
}

std::string lost_text(const RunReport& report) {
    std::string text;
    for (const AlarmRecord& alarm : report.figures.alarms) {
        const auto lost = report::lost_steps_of(alarm, report.table);
        if (lost) text += "lost       " + report::lost_steps_text(*lost) + "\n";
    }
    return text;
}

std::string verification_text(const RunReport& report) {
    if (!report.verification) return "not verified: " + report.unverified_reason;
    const verify::VerifyReport& seen = *report.verification;
    if (!seen.ok) return "NO: " + report::difference_text(seen);
    if (!report.lost_steps.empty()) return "NO: the pins are right, and the simulated machine lost steps";
    if (seen.is_dry) return "yes: a dry run, whose pins obey rules 2 to 4; it carves nothing";
    std::string text =
        formatted("yes: %llu points visited exactly%s, largest deviation %lld pulses",
                  static_cast<unsigned long long>(seen.points_visited), verify::judged_text(seen).c_str(),
                  static_cast<long long>(seen.max_deviation_pulses));
    if (seen.uncarved_cells > 0) {
        text += formatted(", %llu cells of the surface reached by no tip",
                          static_cast<unsigned long long>(seen.uncarved_cells));
    }
    return text;
}

std::string model_text(const RunReport& report) {
    if (!report.undercut_share && !report.open_points) return {};
    return formatted("model      undercut %.2f %%, open points %llu\n",
                     100.0 * report.undercut_share.value_or(0.0),
                     static_cast<unsigned long long>(report.open_points.value_or(0)));
}

std::string passes_text(const RunReport& report) {
    std::string text;
    if (!report.verification) return text;
    for (const verify::PassTime& pass : report.verification->passes) {
        text += "pass       " + pass.name + ": " + std::to_string(pass.layers) + " layers, " +
                clock_text(pass.seconds) + "\n";
    }
    return text;
}

std::string carving_text(const RunReport& report) {
    const machine::RunFigures& figures = report.figures;
    std::string text = "not finished, ";
    if (figures.carve_seconds) text = clock_text(*figures.carve_seconds) + " of machine time, ";
    if (report.seconds_so_far)
        text = "not finished: " + clock_text(*report.seconds_so_far) + " of machine time, ";
    return "carving    " + text + clock_text(figures.total_seconds) + " with approach and retraction\n";
}

std::string machine_text(const RunReport& report) {
    if (report.last.is_simulator == 0) return {};
    return "machine    " + (report.lost_steps.empty() ? "no step lost" : "STEPS LOST: " + report.lost_steps) +
           "\n";
}

}  // namespace

std::string run_text(const RunReport& report) {
    const machine::RunFigures& figures = report.figures;
    const double ticks_per_second =
        report.wall_seconds > 0.0 ? static_cast<double>(figures.ticks) / report.wall_seconds : 0.0;
    std::string text =
        formatted("job        %s: %u layers x %u points\n", report.source_name.substr(0, 150).c_str(),
                  report.layer_count, report.point_count);
    text += "pulses     " + pulses_text(figures.pulses) + "\n";
    text += carving_text(report);
    text += passes_text(report);
    if (report.reference_seconds) text += "reference  " + clock_text(*report.reference_seconds) + "\n";
    text += formatted("run        %.2f s, %llu ticks (%.2f million a second), %llu missed\n",
                      report.wall_seconds, static_cast<unsigned long long>(figures.ticks),
                      ticks_per_second / 1e6, static_cast<unsigned long long>(figures.missed_ticks));
    text += "alarms     " + alarms_text(figures) + "\n";
    text += lost_text(report);
    text += "verified   " + verification_text(report) + "\n";
    text += machine_text(report);
    text += model_text(report);
    if (report.deviation) text += "deviation  " + piece::deviation_text(*report.deviation) + "\n";
    for (const std::string* path : {&report.picture_path, &report.deviation_path}) {
        if (!path->empty()) text += "picture    " + *path + "\n";
    }
    if (!report.piece_path.empty()) text += "piece      " + report.piece_path + "\n";
    return text;
}

int print_run(const RunReport& report, bool as_json) {
    clear_progress_line();
    std::printf("%s", (as_json ? report::run_json(report) + "\n" : run_text(report)).c_str());
    const auto error = report::verdict_of(report);
    if (!error) return kExitDone;
    std::fflush(stdout);
    print_error(*error);
    return report::run_exit_code(report, *error);
}

}  // namespace psicarve::cli
