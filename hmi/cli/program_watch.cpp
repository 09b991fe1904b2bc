// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_watch.hpp"

#include <algorithm>
#include <string>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/program_text.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cli {
namespace {

std::string line_text(const ProgramStatus& program) {
    return "line " + std::to_string(program.line);
}

}  // namespace

void ProgramWatch::tell_hold(const ProgramReport& report) {
    if (!told_hold_.is_new(report.status.hold, report.status.sequence)) return;
    if (report.status.hold == ProgramHold::single) return;  // every block: the bar tells
    clear_progress_line();
    print_note(program_place_text(report));
}

Result<void> ProgramWatch::look(const CoreStatus& status) {
    const ProgramReport report = program_report(link_.segment());
    const ProgramStatus& program = report.status;
    if (quiet_label_ == nullptr) tell_hold(report);
    if (follow_) follow_(report);
    most_override_percent_ = std::max(most_override_percent_, std::uint32_t{status.override_percent});
    was_held_ = was_held_ || status.state == MachineState::held || program.starvations > 0;
    bar_.relabel(quiet_label_ != nullptr ? std::string{quiet_label_} : std::string{name_of(status.state)});
    const double done =
        line_count_ == 0 ? 0.0 : static_cast<double>(program.line) / static_cast<double>(line_count_);
    bar_.update(std::min(done, 1.0), line_text(program));
    return operator_break_.pass_on(link_);
}

namespace {

/// More follows.
std::string without_full_stop(const std::string& sentence) {
    return sentence.ends_with('.') ? sentence.substr(0, sentence.size() - 1) : sentence;
}

}  // namespace

Result<ProgramRun> run_program(machine::MachineLink& link, const ProgramStart& start, ProgramWatch& watch) {
    const auto before = link.status();
    if (!before) return before.error();
    Command command{};
    command.kind = CommandKind::program;
    command.value2 = start.program;
    command.axis = start.switches;
    for (std::size_t k = 0; k < kAxisCount; ++k)
        command.target[k] = static_cast<double>(start.status.position_pulses[k]);
    if (const auto sent = link.send(command); !sent) return sent.error();
    const auto ended = link.wait_for_state({MachineState::ready},
                                           [&](const CoreStatus& status) { return watch.look(status); });
    const ProgramReport report = program_report(link.segment());
    if (!ended) {
        Error error = ended.error();
        if (report.status.program == start.program && was_broken_off(report.status))
            error.message = without_full_stop(error.message) + "; it ended " + broken_off_text(report.status);
        return error;
    }
    const bool is_whole = report.progress.program == start.program &&
                          report.progress.end == static_cast<std::uint32_t>(ProgramEnd::ended) &&
                          report.status.program == start.program && report.status.is_done != 0;
    if (!is_whole) {
        return Error{ErrorCode::machine_refused, "the program ended before its end, in " +
                                                     line_text(report.status) +
                                                     ": somebody stopped it; --from-line goes on"};
    }
    const std::int64_t ticks = static_cast<std::int64_t>(ended->tick - before->tick);
    const std::uint32_t most_percent =
        std::max(std::uint32_t{before->override_percent}, watch.most_override_percent());
    return ProgramRun{report.status, seconds_from_ns(ticks * ended->period_ns), most_percent,
                      watch.was_held() || report.status.starvations > 0};
}

}  // namespace psicarve::cli
