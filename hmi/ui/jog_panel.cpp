// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/jog_panel.hpp"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QResizeEvent>
#include <QSlider>

#include <chrono>

#include "hmi/ui/move_dialog.hpp"
#include "hmi/ui/order_card.hpp"

namespace psicarve::ui {
namespace {

/// A shorter press is a click.
constexpr std::chrono::milliseconds kClickLimit{250};
constexpr double kStepScale = 100.0;  // steps are kept as whole hundredths
constexpr double kLinearScale = 10.0;
constexpr int kMostLinear = 100;  // tenths of mm/s
constexpr int kMostAngular = 225;
constexpr int kUsualLinear = 50;
constexpr int kUsualAngular = 45;
constexpr int kFullHeight = 356;  // with two lines of a hint, in the longest language

}  // namespace

JogPanel::JogPanel(WindowContext& context, QWidget* parent)
    : Dock(tr("Jog"), parent), context_(context), hint_(role_label("label")) {
    body().addWidget(step_row("mm", {0.01, 0.1, 1, 10}, linear_steps_, 1));
    body().addWidget(step_row("°", {0.1, 1, 10, 90}, angular_steps_, 1));
    auto* pad = new QGridLayout;
    pad->setSpacing(kSmallGap);
    body().addLayout(pad);
    add_key(tr("R1 out"), Axis::r1, true, Glyph::left, "jog_r1_out");
    add_key(tr("Y up"), Axis::y, true, Glyph::up, "jog_y_up");
    add_key(tr("R2 out"), Axis::r2, true, Glyph::right, "jog_r2_out");
    add_key(tr("R1 in"), Axis::r1, false, Glyph::right, "jog_r1_in");
    add_key(tr("Y down"), Axis::y, false, Glyph::down, "jog_y_down");
    add_key(tr("R2 in"), Axis::r2, false, Glyph::left, "jog_r2_in");
    add_key("Ψ −", Axis::psi, false, Glyph::turn_right, "jog_psi_minus");
    add_key("Ψ +", Axis::psi, true, Glyph::turn_left, "jog_psi_plus");
    make_heads_keys(*pad);
    for (std::size_t i = 0; i < 8; ++i) {
        // The table's two keys stand at the sides.
        const int place = static_cast<int>(i) + (i == 7 ? 1 : 0);
        pad->addWidget(keys_[i].button, place / 3, place % 3);
    }
    body().addLayout(speed_row(tr("linear"), linear_speed_, linear_label_));
    body().addLayout(speed_row("Ψ", angular_speed_, angular_label_));
    linear_steps_->setObjectName("jog_linear_step");
    angular_steps_->setObjectName("jog_angular_step");
    linear_speed_->setObjectName("jog_linear_speed");
    angular_speed_->setObjectName("jog_angular_speed");
    linear_speed_->setRange(1, kMostLinear);
    linear_speed_->setValue(kUsualLinear);
    angular_speed_->setRange(1, kMostAngular);
    angular_speed_->setValue(kUsualAngular);
    linear_speed_->setAccessibleName(tr("Jog speed of R1, R2 and Y"));
    angular_speed_->setAccessibleName(tr("Jog speed of Ψ"));
    make_more_buttons();
    make_arm_button();
    hint_->setWordWrap(true);
    hint_->setObjectName("jog_hint");
    body().addWidget(hint_);
    refused_ = new OrderCard{context_, session::OrderPlace::jog, "jog", OrderCard::Shape::high, this};
    follow_fields();
    body().addStretch();
    hold_timer_.setSingleShot(true);
    hold_timer_.setInterval(kClickLimit);
    connect(&hold_timer_, &QTimer::timeout, this, [this] {
        is_held_ = true;
        context_.machine.jog().hold(pressed_axis_, pressed_up_, speed_of(pressed_axis_));
    });
}

JogPanel::~JogPanel() = default;

/// What was refused was another step, or at another speed.
void JogPanel::follow_fields() {
    const auto forget = [this] { context_.machine.forget_refused_order(session::OrderPlace::jog); };
    for (QButtonGroup* steps : {linear_steps_, angular_steps_})
        connect(steps, &QButtonGroup::idToggled, this, forget);
    for (QSlider* speed : {linear_speed_, angular_speed_})
        connect(speed, &QSlider::valueChanged, this, forget);
}

void JogPanel::make_heads_keys(QGridLayout& pad) {
    add_key(QStringLiteral("←→"), machine::JogAxis::heads(), true, std::nullopt, "jog_heads_out");
    add_key(QStringLiteral("→←"), machine::JogAxis::heads(), false, std::nullopt, "jog_heads_in");
    auto* both = new QHBoxLayout;
    both->setSpacing(2);
    const QString hints[] = {tr("Both heads out"), tr("Both heads in")};
    for (std::size_t i = 0; i < 2; ++i) {
        ActionButton* button = keys_[keys_.size() - 2 + i].button;
        button->set_hint(hints[i]);
        button->setAccessibleName(hints[i]);
        both->addWidget(button);
    }
    pad.addLayout(both, 2, 1);
}

QWidget* JogPanel::step_row(const QString& unit, const std::vector<double>& steps, QButtonGroup*& group,
                            int chosen) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout{row};
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    QLabel* label = role_label("label", unit);
    label->setFixedWidth(26);
    layout->addWidget(label);
    group = new QButtonGroup{row};
    for (std::size_t i = 0; i < steps.size(); ++i) {
        auto* button = new QPushButton{QString::number(steps[i])};
        button->setObjectName(
            QStringLiteral("jog_step_%1_%2").arg(button->text(), unit == "mm" ? "mm" : "deg"));
        button->setCheckable(true);
        button->setProperty("small", true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAccessibleName(tr("Step %1 %2").arg(QString::number(steps[i]), unit));
        button->setChecked(static_cast<int>(i) == chosen);
        group->addButton(button, qRound(steps[i] * kStepScale));
        layout->addWidget(button, 1);
    }
    return row;
}

QLayout* JogPanel::speed_row(const QString& name, QSlider*& slider, QLabel*& label) {
    auto* layout = new QHBoxLayout;
    QLabel* title = role_label("label", name);
    title->setFixedWidth(40);
    slider = new QSlider{Qt::Horizontal};
    ignore_wheel(slider);
    slider->setFocusPolicy(Qt::TabFocus);
    label = new QLabel;
    label->setFixedWidth(68);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(title);
    layout->addWidget(slider, 1);
    layout->addWidget(label);
    return layout;
}

void JogPanel::add_key(const QString& text, machine::JogAxis axis, bool up, std::optional<Glyph> glyph,
                       const char* name) {
    auto* button = new ActionButton{session::Action::jog, text, {}};
    button->setObjectName(name);
    button->setProperty("key", true);
    if (axis.number() == index_of(Axis::r1)) button->setProperty("head", "r1");
    if (axis.number() == index_of(Axis::r2)) button->setProperty("head", "r2");
    const Key key{button, axis, up, glyph};
    connect(button, &QPushButton::pressed, this, [this, key] { press(key); });
    connect(button, &QPushButton::released, this, [this] { release(); });
    keys_.push_back(key);
}

double JogPanel::speed_of(machine::JogAxis axis) const {
    return axis.is_turned() ? angular_speed_->value() : linear_speed_->value() / kLinearScale;
}

double JogPanel::step_of(machine::JogAxis axis) const {
    return (axis.is_turned() ? angular_steps_ : linear_steps_)->checkedId() / kStepScale;
}

void JogPanel::press(const Key& key) {
    pressed_axis_ = key.axis;
    pressed_up_ = key.up;
    is_held_ = false;
    hold_timer_.start();
}

void JogPanel::release() {
    if (hold_timer_.isActive()) {
        hold_timer_.stop();
        const double distance = step_of(pressed_axis_);
        context_.machine.jog().step(pressed_axis_, pressed_up_ ? distance : -distance,
                                    speed_of(pressed_axis_));
        return;
    }
    if (is_held_) context_.machine.jog().release();
    is_held_ = false;
}

void JogPanel::let_go() {
    disarm();
    hold_timer_.stop();
    is_held_ = false;
    context_.machine.jog().release();
    for (const Key& key : keys_) key.button->setDown(false);
}

void JogPanel::set_theme(const Tokens& tokens) {
    for (const Key& key : keys_) {
        if (!key.glyph) continue;
        const bool is_r1 = key.axis.number() == index_of(Axis::r1);
        const bool is_r2 = key.axis.number() == index_of(Axis::r2);
        const QColor& colour = is_r1 ? tokens.r1 : is_r2 ? tokens.r2 : tokens.text;
        key.button->setIcon(glyph_icon(*key.glyph, colour, tokens.dis));
    }
    refused_->set_theme(tokens);
    move_->set_theme(tokens);
    refresh();
}

void JogPanel::resizeEvent(QResizeEvent* event) {
    // Where room is short its three wide buttons give it; keys for a hand stay as large as they are.
    const bool is_low = event->size().height() < kFullHeight;
    for (ActionButton* button : {go_to_, spindle_, arm_}) set_styled(button, "small", is_low);
    body().setContentsMargins(kGap, kSmallGap, kGap, is_low ? kSmallGap : kGap);
    Dock::resizeEvent(event);
}

void JogPanel::refresh() {
    QString reason;
    for (const Key& key : keys_) reason = key.button->refresh(context_);
    const bool is_armed = keyboard_.is_armed();
    if (!reason.isEmpty() && (is_held_ || hold_timer_.isActive() || is_armed)) let_go();
    if (keyboard_.is_over(session::KeyboardJog::Clock::now())) disarm();
    arm_->refresh(context_);
    go_to_->refresh(context_);
    const bool is_on = context_.machine.view().is_active(Signal::spindle);
    spindle_->setText(is_on ? tr("Stop spindle") : tr("Start spindle"));
    spindle_->refresh(context_);
    move_->refresh();
    hint_->setText(!reason.isEmpty()      ? reason
                   : keyboard_.is_armed() ? tr("Keys move the machine; F9 ends it.")
                                          : tr("Hold = move, click = one step."));
    refused_->refresh_beside(*this, *keys_.front().button);
    note().setText(reason.isEmpty() ? QString{} : tr("locked"));
    linear_label_->setText(tr("%1 mm/s").arg(speed_of(Axis::y), 0, 'f', 1));
    angular_label_->setText(tr("%1 °/s").arg(angular_speed_->value()));
}

}  // namespace psicarve::ui
