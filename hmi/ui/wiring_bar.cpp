// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/wiring_bar.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>

#include "hmi/session/axis_actions.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/order_card.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::WiringTrial;

constexpr int kMostPulses = 10'000;
constexpr int kUsualPulses = 200;
constexpr int kMostRate_hz = 500;
constexpr int kUsualRate_hz = 50;

QSpinBox* number_field(int most, int usual, const QString& unit, const char* name) {
    auto* field = new QSpinBox;
    ignore_wheel(field);
    field->setRange(1, most);
    field->setValue(usual);
    field->setSuffix(QStringLiteral(" ") + unit);
    field->setObjectName(name);
    return field;
}

}  // namespace

WiringBar::WiringBar(WindowContext& context, QWidget* parent)
    : QFrame(parent), context_(context), text_(role_label("label")), left_(role_label("head")) {
    setObjectName("wiring");
    text_->setWordWrap(true);
    arm_ = new ActionButton{[](const WindowContext& now) { return session::wiring_lock(now.machine.view()); },
                            QString{},
                            [this] {
                                if (test_.is_armed()) return let_go();
                                test_.arm(WiringTrial::Clock::now());
                                refresh();
                            }};
    arm_->setObjectName("arm_wiring");
    arm_->set_hint(tr("Then outputs can be switched one by one"));
    drives_off_ = new ActionButton{
        [](const WindowContext& now) { return session::drives_off_lock(now.machine.view()); },
        tr("Drives off"),
        [this] { context_.machine.order(CommandKind::drives_off, session::phrase("Drives off")); }};
    drives_off_->setObjectName("drives_off");
    drives_off_->set_hint(tr("Positions are lost; home again afterwards"));
    auto* head = new QHBoxLayout;
    head->addWidget(role_label("head", tr("Wiring test")));
    head->addWidget(text_, 1);
    head->addWidget(left_);
    head->addWidget(drives_off_);
    head->addWidget(arm_);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kSmallGap, kGap, kSmallGap);
    all->setSpacing(kSmallGap);
    all->addLayout(head);
    make_armed_row();
    all->addWidget(armed_row_);
    refused_ = new OrderCard{context_, session::OrderPlace::outputs, "outputs", OrderCard::Shape::wide, this};
}

void WiringBar::set_theme(const Tokens& tokens) {
    refused_->set_theme(tokens);
}

void WiringBar::make_armed_row() {
    outputs_ = new ChoiceBox;
    outputs_->setObjectName("test_output");
    outputs_->setAccessibleName(tr("Output to test"));
    rate_ = number_field(kMostRate_hz, kUsualRate_hz, "Hz", "test_rate");
    rate_->setAccessibleName(tr("Pulses in a second"));
    pulses_ = number_field(kMostPulses, kUsualPulses, tr("pulses"), "test_pulses");
    pulses_->setAccessibleName(tr("How many pulses"));
    const auto lock = [this](const WindowContext& /*context*/) { return step_lock(); };
    send_ = new ActionButton{lock, tr("Send pulses"), [this] { send_pulses(); }};
    send_->setObjectName("send_pulses");
    hold_ = new ActionButton{lock, tr("Hold for high"), {}};
    hold_->setObjectName("hold_high");
    connect(hold_, &QPushButton::pressed, this, [this] { hold(true); });
    connect(hold_, &QPushButton::released, this, [this] { hold(false); });
    armed_row_ = new QWidget;
    auto* row = new QHBoxLayout{armed_row_};
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(outputs_, 2);
    row->addWidget(rate_, 1);
    row->addWidget(pulses_, 1);
    row->addWidget(send_, 1);
    row->addWidget(hold_, 1);
    // What was refused was another test.
    const auto forget = [this] { context_.machine.forget_refused_order(session::OrderPlace::outputs); };
    connect(outputs_, &QComboBox::currentIndexChanged, this, forget);
    for (QSpinBox* number : {rate_, pulses_}) connect(number, &QSpinBox::valueChanged, this, forget);
}

void WiringBar::show_rows(const std::vector<session::PinRow>& rows) {
    outputs_->clear();
    for (const session::PinRow& row : rows) {
        if (!is_output(row.signal) || row.pin == 0) continue;
        outputs_->addItem(QString{"%1 · %2"}.arg(row.pin).arg(words(row.name)),
                          static_cast<int>(index_of(row.signal)));
    }
}

Signal WiringBar::output() const {
    return static_cast<Signal>(outputs_->currentData().toInt());
}

std::optional<session::Phrase> WiringBar::step_lock() const {
    if (!test_.is_armed()) return session::phrase("Wiring test: arm it first");
    return session::wiring_lock(context_.machine.view());
}

void WiringBar::send_pulses() {
    test_.use(WiringTrial::Clock::now());
    context_.machine.jog().test(output(), static_cast<std::uint32_t>(pulses_->value()), rate_->value());
}

void WiringBar::hold(bool is_down) {
    test_.use(WiringTrial::Clock::now());
    if (is_down) {
        context_.machine.jog().test(output(), 0, 0.0);
    } else {
        context_.machine.jog().release();
    }
}

void WiringBar::let_go() {
    if (!test_.is_armed()) return;
    test_.disarm();
    hold_->setDown(false);
    context_.machine.jog().release();
    refresh();
}

void WiringBar::refresh() {
    const auto now = WiringTrial::Clock::now();
    if (hold_->isDown()) test_.use(now);
    const QString locked = arm_->refresh(context_);
    drives_off_->refresh(context_);
    if (test_.is_armed() && (!locked.isEmpty() || test_.left(now).count() == 0)) return let_go();
    const bool is_armed = test_.is_armed();
    arm_->setText(is_armed ? tr("Disarm") : tr("Arm"));
    drives_off_->setVisible(!is_armed);
    armed_row_->setVisible(is_armed);
    left_->setText(is_armed ? tr("%1 s").arg(test_.left(now).count()) : QString{});
    text_->setText(is_armed
                       ? tr("Armed for one output, all others off. Ends after 30 s, on focus loss or F1.")
                   : locked.isEmpty() ? tr("Switches one output at a time. Home again afterwards.")
                                      : locked);
    set_styled(this, "armed", is_armed ? "yes" : "no");
    for (ActionButton* button : {send_, hold_}) button->refresh(context_);
    refused_->refresh_above(*this);
}

}  // namespace psicarve::ui
