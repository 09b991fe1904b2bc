// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/axis_table.hpp"

#include <QGridLayout>
#include <QLabel>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/frames.hpp"

namespace psicarve::ui {
namespace {

const QString kNone = QStringLiteral("\u2013");
constexpr int kAxisColumns = 5;

void say(QLabel* label, const QString& text) {
    if (label->text() != text) label->setText(text);
}

}  // namespace

AxisTable::AxisTable(WindowContext& context, QWidget* parent) : QWidget(parent), context_(context) {
    setObjectName("axis_table");
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins(kGap, 0, kGap, 0);
    grid->setVerticalSpacing(1);
    const QString heads[] = {tr("Axis"), tr("Pulses since start"), tr("Speed"), tr("Of top speed"),
                             tr("Pulses to go")};
    for (int column = 0; column < kAxisColumns; ++column) {
        grid->addWidget(role_label("label", heads[column]), 0, column,
                        column == 0 ? Qt::AlignLeft : Qt::AlignRight);
        grid->setColumnStretch(column, 1);
    }
    for (const Axis axis : kAllAxes) {
        Row& row = rows_[index_of(axis)];
        row = {new QLabel{QString::fromUtf8(session::axis_letter(axis))}, new QLabel, new QLabel, new QLabel,
               new QLabel};
        const QString id = QString::fromStdString(std::string{name_of(axis)});
        row.speed->setObjectName("axis_speed_" + id);
        row.pulses->setObjectName("axis_pulses_" + id);
        row.share->setObjectName("axis_share_" + id);
        row.left->setObjectName("axis_left_" + id);
        row.pulses->setToolTip(tr("Emitted since Start: the ways in and out, and back from a hold, as well"));
        row.left->setToolTip(tr("From point to point as the job's tables have it"));
        QLabel* const labels[] = {row.name, row.pulses, row.speed, row.share, row.left};
        // A figure has its whole column: it grows while the machine moves, and nothing is laid out anew.
        for (int column = 0; column < kAxisColumns; ++column) {
            labels[column]->setAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            grid->addWidget(labels[column], static_cast<int>(index_of(axis)) + 1, column);
        }
    }
}

void AxisTable::set_theme(const Tokens& tokens) {
    const QColor colours[kAxisCount] = {tokens.r1, tokens.r2, tokens.text, tokens.text};
    for (const Axis axis : kAllAxes) {
        rows_[index_of(axis)].name->setStyleSheet(
            QString{"font-weight: 700; color: %1"}.arg(colours[index_of(axis)].name()));
    }
}

void AxisTable::refresh() {
    const session::MachineView& machine_view = context_.machine.view();
    if (machine_view.core_pid != core_pid_) rates_.forget();
    core_pid_ = machine_view.core_pid;
    if (machine_view.is_heard() && machine_view.status)
        rates_.note(*machine_view.status, session::RateMeter::Clock::now());
    if (!isVisible()) return;
    const auto& shown = context_.shown().status;
    for (const Axis axis : kAllAxes) {
        const bool is_told = shown && !context_.replay.is_open();
        say(rows_[index_of(axis)].pulses,
            is_told ? QString::fromStdString(session::count_text(
                          static_cast<std::int64_t>(shown->emitted_pulses[index_of(axis)])))
                    : kNone);
        show_speed(axis);
    }
    show_pulses_to_go();
}

QString AxisTable::feed_text() const {
    const session::MachineView& machine_view = context_.machine.view();
    if (!machine_view.is_heard() || !machine_view.profile || !machine_view.status ||
        context_.replay.is_open())
        return {};
    const double feed_mm_s = session::surface_speed_mm_s(rates_, *machine_view.status, *machine_view.profile);
    return tr("feed %1 mm/s").arg(QString::fromStdString(session::number_text(feed_mm_s, 1)));
}

void AxisTable::show_pulses_to_go() {
    const auto& status = context_.shown().status;
    const auto job = context_.replay.is_open() ? nullptr : context_.job_at_work();
    const bool is_told = status && job && !job->pulses_to_end.empty() &&
                         status->layer < job->view.layer_count() && status->point < job->view.point_count();
    if (!is_told) {
        for (const Row& row : rows_) say(row.left, kNone);
        return;
    }
    const cam::PulseCounts left =
        cam::pulses_to_go(job->view, job->pulses_to_end, status->layer, status->point);
    for (const Axis axis : kAllAxes)
        say(rows_[index_of(axis)].left,
            QString::fromStdString(session::count_text(static_cast<std::int64_t>(left[index_of(axis)]))));
}

void AxisTable::show_speed(Axis axis) {
    constexpr double kPercent = 100.0;
    const session::MachineView& machine_view = context_.machine.view();
    const Row& row = rows_[index_of(axis)];
    if (!machine_view.is_heard() || !machine_view.profile || context_.replay.is_open()) {
        say(row.speed, kNone);
        return say(row.share, kNone);
    }
    const AxisMotion motion = axis_motion(*machine_view.profile, axis);
    const double speed = rates_.pulses_per_machine_s(axis) / motion.pulses_per_unit;
    const char* const unit = axis == Axis::psi ? "%1 °/s" : "%1 mm/s";
    say(row.speed, QString::fromUtf8(unit).arg(QString::fromStdString(session::number_text(speed, 1))));
    const double share = rates_.pulses_per_machine_s(axis) / motion.speed_pps;
    say(row.share, QString{"%1 %"}.arg(QString::fromStdString(session::number_text(kPercent * share, 0))));
}

}  // namespace psicarve::ui
