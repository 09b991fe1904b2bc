// SPDX-License-Identifier: GPL-3.0-or-later
// What page Program says of what holds: where the machine is, and where a program begins.
#include <QStringList>

#include <cmath>

#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/work_offsets.hpp"
#include "hmi/report/program_modes.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/program_page.hpp"

namespace psicarve::ui {
namespace {

constexpr int kModesDecimals = 3;

QString place_number(double value) {
    const double shown = std::abs(value) < 0.0005 ? 0.0 : value;
    return QString::fromStdString(session::number_text(shown, kModesDecimals));
}

QString of_codes(const ProgramModes& modes) {
    const std::string words = report::words_text(modes, "  ");
    return QString::fromStdString(report::codes_text(modes) + (words.empty() ? "" : "   ") + words);
}

/// Its end: the whole of it, which the tool tip has, may be longer than the page is wide.
QString short_path(const std::string& path) {
    constexpr qsizetype kMostLetters = 40;
    const QString whole = QString::fromStdString(path);
    if (whole.size() <= kMostLetters) return whole;
    return QChar{0x2026} + whole.right(kMostLetters - 1);
}

}  // namespace

QString ProgramPage::places_text(const std::array<double, kAxisCount>& places) const {
    const auto of = [&](Axis axis) { return place_number(places[index_of(axis)]); };
    return tr("R1 %1 · R2 %2 · Y %3 mm · Ψ %4°").arg(of(Axis::r1), of(Axis::r2), of(Axis::y), of(Axis::psi));
}

/// Of the program that runs, another process' one, too; empty: none does.
QString ProgramPage::modes_text() const {
    const ProgramReport& report = context_.program_report;
    const session::MachineView& machine = context_.machine.view();
    if (report.status.is_running == 0 || !machine.is_heard() || !machine.status) return {};
    QStringList lines;
    QString left = QStringLiteral("–");
    if (report.modes && !report::codes_text(*report.modes).empty()) {
        const ProgramModes& modes = *report.modes;
        QString codes = of_codes(modes);
        if (!report::is_at_hand(modes, report.status)) codes += ' ' + tr("(told of line %1)").arg(modes.line);
        lines += codes;
        const QString system = QString::fromStdString(report::system_text(modes));
        if (!system.isEmpty() && report::has_numbers(modes.zero)) {
            QString zero = tr("Zero of %1: %2").arg(system, places_text(modes.zero));
            if (const auto turn_deg = report::shown_number(modes.rotation_deg); turn_deg.value_or(0.0) != 0.0)
                zero += ", " + tr("turned by %1°").arg(place_number(*turn_deg));
            lines += zero;
        }
        const auto to_go = context_.knows_core_profile()
                               ? report::to_go(modes, report.status, *machine.status, *machine.profile)
                               : std::nullopt;
        if (to_go) left = places_text(*to_go);
    }
    lines += tr("To go: %1").arg(left) + QStringLiteral(" · ") +
             tr("queue: %1 of %2").arg(report.queued).arg(report.ring_records);
    return lines.join('\n');
}

/// Which work offsets the program that was read begins with, and whose.
QString ProgramPage::offsets_text() const {
    const auto& read = context_.program.program();
    if (!read || read->offsets_path.empty()) return {};
    const QString system = QString::fromUtf8(gcode::kSystemNames[0].data());
    const QString whose = short_path(read->offsets_path);
    if (read->offsets == gcode::KeptOffsets{})
        return tr("Begins in %1 at the machine's zero, as %2 has it.").arg(system, whose);
    const gcode::Position zero = gcode::WorkOffsets{read->offsets}.to_machine({});
    const gcode::AxisMask moved = gcode::AxisLetters{read->request.profile.gcode}.all();
    QString places;
    for (std::size_t letter = 0; letter < gcode::kLetterCount; ++letter) {
        if ((moved & gcode::mask_of(letter)) == 0) continue;
        places += QStringLiteral(" ") + QLatin1Char{gcode::kAxisLetters[letter]} + QStringLiteral(" ") +
                  place_number(zero[letter]);
    }
    if (const double turn_deg = read->offsets.systems[0].rotation_deg; turn_deg != 0.0)
        places += ", " + tr("turned by %1°").arg(place_number(turn_deg));
    return tr("Begins in %1 (zero%2) with the work offsets of %3.").arg(system, places, whose);
}

}  // namespace psicarve::ui
