// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/position_panel.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>

#include <algorithm>
#include <functional>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/last_known.hpp"
#include "hmi/ui/order_card.hpp"
#include "hmi/ui/settings.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kPositionPanelBarWidth = 4;
constexpr int kLampWidth = 58;
constexpr int kLampHeight = 18;
constexpr int kUnitWidth = 26;
constexpr int kPositionPanelNameWidth = 56;

/// A row that a click, or Space on it, selects.
class AxisRow : public QFrame {
public:
    explicit AxisRow(std::function<void()> selected) : selected_(std::move(selected)) {
        setProperty("axis_row", true);
        setFocusPolicy(Qt::TabFocus);
    }

protected:
    void mousePressEvent(QMouseEvent* /*event*/) override { selected_(); }
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() != Qt::Key_Space) return QFrame::keyPressEvent(event);
        selected_();
    }

private:
    std::function<void()> selected_;
};

QLabel* lamp() {
    auto* label = new QLabel;
    label->setFixedSize(kLampWidth, kLampHeight);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

}  // namespace

PositionPanel::PositionPanel(WindowContext& context, QWidget* parent)
    : Dock(tr("Position"), parent), context_(context) {
    body().setContentsMargins(0, 0, 0, kGap);
    body().setSpacing(0);
    for (const Axis axis : kAllAxes) {
        body().addWidget(make_row(axis));
        body().addWidget(rule());
    }
    home_ = new ActionButton{session::Action::home, tr("Home all"),
                             [this] { context_.machine.order(CommandKind::home, session::phrase("Home")); }};
    home_->setObjectName("home");
    home_->set_hint(tr("R1 and R2 out, then Y, then Ψ to its index (Ctrl+Home)"));
    home_->setShortcut(Qt::CTRL | Qt::Key_Home);
    home_one_ = new ActionButton{
        [this](const WindowContext& now) { return session::home_lock(now.machine.view(), selected_); },
        QString{}, [this] { home_selected(); }};
    home_one_->setObjectName("home_one");
    zero_one_ = new ActionButton{
        [this](const WindowContext& now) { return session::zero_lock(now.machine.view(), selected_); },
        QString{}, [this] { change_zero(); }};
    zero_one_->setObjectName("zero_one");
    take_zeros();
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(kGap, kGap, kGap, 0);
    buttons->setSpacing(kSmallGap);
    buttons->addWidget(zero_one_, 1);
    buttons->addWidget(home_one_, 1);
    buttons->addWidget(home_, 1);
    body().addLayout(buttons);
    refused_ =
        new OrderCard{context_, session::OrderPlace::position, "position", OrderCard::Shape::high, this};
    select(Axis::r1);
}

void PositionPanel::take_zeros() {
    const WindowSettings settings{*context_.settings};
    for (const Axis axis : kAllAxes)
        zero_.set(axis, settings.zero(context_.machine.options().segment_name, axis));
}

QWidget* PositionPanel::make_row(Axis axis) {
    Row& row = rows_[index_of(axis)];
    auto* widget = new AxisRow{[this, axis] { select(axis); }};
    widget->setObjectName(QString{"axis_%1"}.arg(QString::fromStdString(std::string{name_of(axis)})));
    widget->setAccessibleName(tr("Select axis %1").arg(session::axis_letter(axis)));
    row.whole = widget;
    auto* grid = new QGridLayout{widget};
    grid->setContentsMargins(0, 1, kSmallGap, 1);
    grid->setHorizontalSpacing(kSmallGap);
    grid->setVerticalSpacing(0);
    row.bar = new QFrame;
    row.bar->setFixedWidth(kPositionPanelBarWidth);
    row.name = role_label("axis", session::axis_letter(axis));
    row.second = role_label("small");
    row.second->setObjectName(QString{"second_%1"}.arg(QString::fromStdString(std::string{name_of(axis)})));
    row.name->setMinimumWidth(kPositionPanelNameWidth);
    row.value = role_label("digits");
    row.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.value->setObjectName(QString{"position_%1"}.arg(QString::fromStdString(std::string{name_of(axis)})));
    row.pulses = role_label("small");
    row.pulses->setAlignment(Qt::AlignRight);
    row.pulses->setObjectName(QString{"pulses_%1"}.arg(QString::fromStdString(std::string{name_of(axis)})));
    row.pulses->hide();
    row.unit = role_label("label");
    row.unit->setFixedWidth(kUnitWidth);
    row.unit->setObjectName(QString{"unit_%1"}.arg(QString::fromStdString(std::string{name_of(axis)})));
    row.homed = lamp();
    row.sensor = lamp();
    row.homed->setObjectName(QString{"homed_%1"}.arg(QString::fromStdString(std::string{name_of(axis)})));
    row.sensor->setObjectName(QString{"sensor_%1"}.arg(QString::fromStdString(std::string{name_of(axis)})));
    grid->addWidget(row.bar, 0, 0, 3, 1);
    grid->addWidget(row.name, 0, 1);
    grid->addWidget(row.second, 1, 1, 2, 1, Qt::AlignTop);
    grid->addWidget(row.value, 0, 2, 2, 1);
    grid->addWidget(row.pulses, 2, 2);
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
    refused_->set_theme(tokens);
    refresh();
}

void PositionPanel::set_room(Room room) {
    is_wide_ = room == Room::wide;
    for (const Row& row : rows_) row.pulses->setVisible(is_wide_);
}

void PositionPanel::refresh() {
    for (const Axis axis : kAllAxes) {
        refresh_row(axis);
        refresh_lamps(axis);
    }
    const session::MachineView& view = context_.shown();
    note().setText(context_.replay.is_open()         ? tr("recorded")
                   : view.is_heard() || !view.status ? QString{}
                                                     : last_known(view));
    refresh_buttons();
}

void PositionPanel::select(Axis axis) {
    if (axis != selected_) context_.machine.forget_refused_order(session::OrderPlace::position);
    selected_ = axis;
    for (const Axis each : kAllAxes)
        set_styled(rows_[index_of(each)].whole, "selected", each == axis ? "yes" : "no");
    refresh_buttons();
}

bool PositionPanel::is_zero_shown() const {
    return session::is_at_zero(session::from_zero(context_.machine.view(), selected_, zero_.of(selected_)));
}

void PositionPanel::refresh_buttons() {
    const QString letter = session::axis_letter(selected_);
    const bool clears = is_zero_shown();
    home_one_->setText(tr("Home %1").arg(letter));
    home_one_->set_hint(tr("%1 alone finds its home position").arg(letter));
    zero_one_->setText(clears ? tr("No zero") : tr("Zero %1").arg(letter));
    zero_one_->set_hint(clears ? tr("Forgets the zero of %1").arg(letter)
                               : tr("Shows how far %1 is from here; no motion changes").arg(letter));
    for (ActionButton* button : {home_, home_one_, zero_one_}) button->refresh(context_);
    refused_->refresh_beside(*this, *home_);
}

void PositionPanel::change_zero() {
    zero_.set(selected_,
              is_zero_shown() ? std::nullopt : session::position_of(context_.machine.view(), selected_));
    WindowSettings{*context_.settings}.set_zero(context_.machine.options().segment_name, selected_,
                                                zero_.of(selected_));
    refresh();
}

// Y alone may always go to its switch; the other axes alone need a core's look at the heads first.
void PositionPanel::home_selected() {
    const session::Phrase name = session::phrase("Home %1", session::axis_letter(selected_));
    if (selected_ == Axis::y) return context_.machine.order(CommandKind::reset_height, name);
    Command command{};
    command.kind = CommandKind::home;
    command.axis = 1U << index_of(selected_);
    context_.machine.order(command, name);
}

void PositionPanel::refresh_row(Axis axis) {
    const session::MachineView& view = context_.shown();
    Row& row = rows_[index_of(axis)];
    const session::AxisReadout readout = session::axis_readout(view, axis);
    row.value->setText(QString::fromStdString(readout.value));
    const bool is_in_pulses = readout.unit == "pulses";
    row.unit->setText(is_in_pulses ? tr("pul.") : QString::fromStdString(readout.unit));
    row.unit->setFixedWidth(std::max(kUnitWidth, row.unit->sizeHint().width()));
    set_styled(row.value, "long", is_in_pulses ? "yes" : "no");
    row.value->setToolTip(words(session::commanded_and_actual(view, axis)));
    if (is_wide_) row.pulses->setText(words(session::pulses_phrase(view, axis)));
    const bool is_known = view.is_heard() || !view.status;
    QFont font = row.value->font();
    if (font.strikeOut() == is_known) {
        font.setStrikeOut(!is_known);
        row.value->setFont(font);
    }
    const QString usual[] = {tr("left"), tr("right"), words(readout.second), tr("height")};
    // A zero is the operator's, for the machine that is there.
    const auto distance =
        context_.replay.is_open() ? std::nullopt : session::from_zero(view, axis, zero_.of(axis));
    QString second = usual[index_of(axis)];
    if (distance) {
        const QString from_zero =
            QString{"Δ %1"}.arg(QString::fromStdString(session::number_text(*distance, 2)));
        // The turns are the machine's own, like the large number: a zero is an angle, and knows of none.
        second = axis == Axis::psi ? from_zero + '\n' + second : from_zero;
    }
    if (row.second->text() != second) row.second->setText(second);
    row.second->setToolTip(distance
                               ? tr("From your zero of %1. The large number is the machine's own position.")
                                     .arg(session::axis_letter(axis))
                               : QString{});
}

/// What a core said before it was lost holds no longer: its guard switches drives off, hands move axes.
bool PositionPanel::is_unheard() const {
    const session::MachineView& view = context_.shown();
    return !context_.replay.is_open() && view.status && !view.is_heard();
}

void PositionPanel::refresh_homed(Axis axis, bool is_homed) {
    Row& row = rows_[index_of(axis)];
    const QString letter = session::axis_letter(axis);
    row.homed->setText(is_homed ? tr("homed") : tr("home ?"));
    row.homed->setAccessibleName(is_homed ? tr("%1: homed").arg(letter) : tr("%1: not homed").arg(letter));
    set_styled(row.homed, "lamp", is_homed ? "good" : "unsure");
}

void PositionPanel::refresh_lamps(Axis axis) {
    const session::MachineView& view = context_.shown();
    Row& row = rows_[index_of(axis)];
    const QString letter = session::axis_letter(axis);
    if (context_.replay.is_open() && !context_.replay.facts().knows_states) {
        row.homed->setText(QStringLiteral("\u2013"));
        row.homed->setAccessibleName(tr("%1: whether it was homed is not recorded").arg(letter));
        set_styled(row.homed, "lamp", "off");
    } else if (is_unheard()) {
        row.homed->setText(tr("home ?"));
        row.homed->setAccessibleName(tr("%1: whether it is homed is not known").arg(letter));
        set_styled(row.homed, "lamp", "unsure");
    } else {
        refresh_homed(axis, view.is_homed(axis));
    }
    if (is_unheard()) {
        row.sensor->setText(axis == Axis::psi ? tr("? index") : tr("? limit"));
        row.sensor->setAccessibleName(axis == Axis::psi ? tr("Ψ index: not known")
                                                        : tr("%1 limit switch: not known").arg(letter));
        set_styled(row.sensor, "lamp", "off");
        return;
    }
    const bool is_active = view.is_active(sensor_of(axis));
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
