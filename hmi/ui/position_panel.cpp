// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/position_panel.hpp"

#include <QGridLayout>
#include <QHBoxLayout>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kBarWidth = 4;
constexpr int kLampWidth = 58;
constexpr int kLampHeight = 18;
constexpr int kUnitWidth = 26;
constexpr int kNameWidth = 56;

QLabel* lamp() {
    auto* label = new QLabel;
    label->setFixedSize(kLampWidth, kLampHeight);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

}  // namespace

PositionPanel::PositionPanel(Bench& bench, QWidget* parent) : Dock(tr("Position"), parent), bench_(bench) {
    body().setContentsMargins(0, 0, 0, kGap);
    body().setSpacing(0);
    for (const Axis axis : kAllAxes) {
        body().addWidget(make_row(axis));
        body().addWidget(rule());
    }
    home_ = new ActionButton{session::Action::home, tr("Home all"),
                             [this] { bench_.machine.order(CommandKind::home, session::phrase("Home")); }};
    home_->setObjectName("home");
    home_->set_hint(tr("R1 and R2 out, then Y, then Ψ to its index (Ctrl+Home)"));
    home_->setShortcut(Qt::CTRL | Qt::Key_Home);
    home_y_ = new ActionButton{session::Action::home_y, tr("Home Y"), [this] {
                                   bench_.machine.order(CommandKind::reset_height, session::phrase("Home Y"));
                               }};
    home_y_->setObjectName("home_y");
    home_y_->set_hint(tr("Y alone to its switch, which defines its position"));
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(kGap, kGap, kGap, 0);
    buttons->setSpacing(kGap);
    buttons->addWidget(home_y_);
    buttons->addWidget(home_);
    body().addLayout(buttons);
}

QWidget* PositionPanel::make_row(Axis axis) {
    Row& row = rows_[index_of(axis)];
    auto* widget = new QWidget;
    auto* grid = new QGridLayout{widget};
    grid->setContentsMargins(0, 1, kSmallGap, 1);
    grid->setHorizontalSpacing(kSmallGap);
    grid->setVerticalSpacing(1);
    row.bar = new QFrame;
    row.bar->setFixedWidth(kBarWidth);
    row.name = role_label("axis", session::axis_letter(axis));
    row.second = role_label("small");
    row.name->setMinimumWidth(kNameWidth);
    row.value = role_label("digits");
    row.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.value->setObjectName(QString{"position_%1"}.arg(QString::fromStdString(std::string{name_of(axis)})));
    row.unit = role_label("label");
    row.unit->setFixedWidth(kUnitWidth);
    row.homed = lamp();
    row.sensor = lamp();
    grid->addWidget(row.bar, 0, 0, 2, 1);
    grid->addWidget(row.name, 0, 1);
    grid->addWidget(row.second, 1, 1);
    grid->addWidget(row.value, 0, 2, 2, 1);
    grid->addWidget(row.unit, 0, 3, 2, 1);
    grid->addWidget(row.homed, 0, 4);
    grid->addWidget(row.sensor, 1, 4);
    grid->setColumnStretch(2, 1);
    return widget;
}

void PositionPanel::set_theme(const Tokens& tokens) {
    const QColor colours[kAxisCount] = {tokens.r1, tokens.r2, tokens.edge, tokens.edge};
    for (const Axis axis : kAllAxes) {
        const QString style =
            QString{"background: %1; border: 0; border-radius: 0;"}.arg(colours[index_of(axis)].name());
        rows_[index_of(axis)].bar->setStyleSheet(style);
    }
    refresh();
}

void PositionPanel::refresh() {
    for (const Axis axis : kAllAxes) {
        refresh_row(axis);
        refresh_lamps(axis);
    }
    const session::MachineSight& sight = bench_.machine.sight();
    note().setText(sight.is_heard() || !sight.status ? QString{} : tr("last known"));
    home_->refresh(bench_);
    home_y_->refresh(bench_);
}

void PositionPanel::refresh_row(Axis axis) {
    const session::MachineSight& sight = bench_.machine.sight();
    Row& row = rows_[index_of(axis)];
    const session::AxisReadout readout = session::axis_readout(sight, axis);
    row.value->setText(QString::fromStdString(readout.value));
    row.unit->setText(readout.unit == "pulses" ? tr("pul.") : QString::fromStdString(readout.unit));
    row.value->setToolTip(words(readout.second));
    const bool is_known = sight.is_heard() || !sight.status;
    QFont font = row.value->font();
    if (font.strikeOut() == is_known) {
        font.setStrikeOut(!is_known);
        row.value->setFont(font);
    }
    switch (axis) {
        case Axis::r1:
            row.second->setText(tr("left"));
            break;
        case Axis::r2:
            row.second->setText(tr("right"));
            break;
        case Axis::psi:
            row.second->setText(words(readout.second));
            break;
        case Axis::y:
            row.second->setText(tr("height"));
            break;
    }
}

void PositionPanel::refresh_lamps(Axis axis) {
    const session::MachineSight& sight = bench_.machine.sight();
    Row& row = rows_[index_of(axis)];
    const QString letter = session::axis_letter(axis);
    const bool is_homed = sight.is_homed(axis);
    row.homed->setText(is_homed ? tr("homed") : tr("home ?"));
    row.homed->setAccessibleName(is_homed ? tr("%1: homed").arg(letter) : tr("%1: not homed").arg(letter));
    set_styled(row.homed, "lamp", is_homed ? "good" : "unsure");
    const bool is_active = sight.is_active(sensor_of(axis));
    if (axis == Axis::psi) {
        row.sensor->setText(is_active ? tr("● index") : tr("○ index"));
        row.sensor->setAccessibleName(is_active ? tr("Ψ index: there") : tr("Ψ index: away"));
        set_styled(row.sensor, "lamp", is_active ? "good" : "off");
        return;
    }
    row.sensor->setText(is_active ? tr("! LIMIT") : tr("○ limit"));
    row.sensor->setAccessibleName(is_active ? tr("%1 limit switch: closed").arg(letter)
                                            : tr("%1 limit switch: open").arg(letter));
    set_styled(row.sensor, "lamp", is_active ? "bad" : "off");
}

}  // namespace psicarve::ui
