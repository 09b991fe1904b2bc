// SPDX-License-Identifier: GPL-3.0-or-later
// What page Program says of its file and of what runs.
#include "hmi/report/program_origin.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/program_page.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {

QString ProgramPage::facts_text() const {
    const program::ProgramDesk& desk = context_.program;
    if (desk.is_reading()) return tr("Reading the program: %1 %").arg(qRound(100.0 * desk.progress_ratio()));
    if (!desk.problem().is_empty()) return words(desk.problem());
    if (!desk.program()) return {};
    if (context_.program.text().failure())
        return tr("The file has been changed since it was read: decode it again.");
    const program::Decoded& read = *desk.program();
    const auto count = [](std::uint64_t number) { return QString::fromStdString(session::counted(number)); };
    QString facts = tr("Lines: %1, moves: %2, errors: %3, warnings: %4")
                        .arg(count(read.facts.line_count), count(read.facts.motion_count),
                             count(read.problems.error_count()), count(read.problems.warning_count()));
    // Before the start; then it is told what holds.
    if (const QString offsets = offsets_text(); !offsets.isEmpty() && modes_text().isEmpty())
        facts += QStringLiteral(" · ") + offsets;
    return facts;
}

/// The name that whoever writes it has told.
QString ProgramPage::origin_name(const ProgramOrigin& origin) {
    switch (report::kind_of(origin)) {
        case report::OriginKind::stream:
            return tr("A stream");
        case report::OriginKind::typed:
            return tr("A typed block");
        case report::OriginKind::file:
            break;
    }
    return QString::fromStdString(report::file_name_of(origin));
}

/// What runs, or how it ended, or why nothing can be started.
QString ProgramPage::state_text() const {
    const program::ProgramDesk& desk = context_.program;
    const ProgramReport& report = context_.program_report;
    const auto name = [&desk] { return QString::fromStdString(desk.started_name()); };
    if (report.status.is_running != 0 && context_.machine.view().is_heard()) {
        const QString place = words(program::place_phrase(report.status, context_.machine.view().state()));
        QString text = desk.is_shown(report.status)             ? tr("The program runs. %1").arg(place)
                       : desk.is_ours(report.status)            ? tr("%1 runs. %2").arg(name(), place)
                       : desk.is_block() && desk.is_under_way() ? tr("The typed block runs. %1").arg(place)
                       : report.origin
                           ? tr("%1 runs, of another process. %2").arg(origin_name(*report.origin), place)
                           : tr("A program of another process runs. %1").arg(place);
        if (report.progress.program == report.status.program)
            text += QStringLiteral(" · ") + tr("taken up to line %1").arg(report.progress.line);
        if (report.status.starvations > 0)
            text += QStringLiteral(" · ") + tr("waited for its lines: %1").arg(report.status.starvations);
        return text;
    }
    if (desk.is_under_way() && !desk.is_block()) return tr("The program is on its way to the machine.");
    if (desk.ended() && !desk.is_block()) {
        return desk.ended()->is_done
                   ? tr("%1 is run.").arg(name())
                   : tr("%1 ended: %2").arg(name(), words(session::error_phrase(desk.ended()->said)));
    }
    return start_->reason();
}

}  // namespace psicarve::ui
