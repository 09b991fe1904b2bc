// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QStackedWidget>
#include <QTextEdit>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/jog_panel.hpp"
#include "hmi/ui/move_dialog.hpp"

namespace psicarve::ui {
namespace {

using session::JogKey;
using session::KeyboardJog;

std::optional<JogKey> jog_key(int key) {
    switch (key) {
        case Qt::Key_Left:
            return JogKey::left;
        case Qt::Key_Right:
            return JogKey::right;
        case Qt::Key_Up:
            return JogKey::up;
        case Qt::Key_Down:
            return JogKey::down;
        case Qt::Key_PageUp:
            return JogKey::page_up;
        case Qt::Key_PageDown:
            return JogKey::page_down;
        default:
            return std::nullopt;
    }
}

/// Keys are for what is written in it.
bool is_text_field(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr ||
           qobject_cast<const QTextEdit*>(widget) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(widget) != nullptr;
}

}  // namespace

void JogPanel::make_arm_button() {
    arm_ = new ActionButton{session::Action::jog, tr("Arm keyboard jog"),
                            [this] { keyboard_.is_armed() ? disarm() : arm(); }};
    arm_->setObjectName("arm_keys");
    arm_->setShortcut(Qt::Key_F9);
    arm_->set_hint(tr("Then keys move the machine (F9)"));
    body().addWidget(arm_);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget* /*before*/, QWidget* now) {
        if (is_text_field(now)) disarm();
    });
}

void JogPanel::make_more_buttons() {
    move_ = new MoveDialog{context_, this};
    go_to_ = new ActionButton{session::Action::jog, tr("Go to…"), [this] { go_to(); }};
    go_to_->setObjectName("go_to");
    go_to_->set_hint(tr("To a position: one axis or several, straight or on an arc"));
    spindle_ =
        new ActionButton{[](const WindowContext& now) { return session::spindle_lock(now.machine.view()); },
                         tr("Start spindle"), [this] { turn_spindle(); }};
    spindle_->setObjectName("spindle");
    spindle_->set_hint(tr("By hand; a job does it by itself, and Stop switches it off"));
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout{buttons};
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSmallGap);
    row->addWidget(go_to_, 1);
    row->addWidget(spindle_, 1);
    auto* keys = role_label("armed", tr("← → Ψ   ↑ ↓ Y   PgUp PgDn R1\nCtrl+PgUp PgDn R2   Shift one step"));
    keys->setObjectName("jog_keys");
    more_ = new QStackedWidget;
    more_->addWidget(buttons);
    more_->addWidget(keys);
    more_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    body().addWidget(more_);
}

void JogPanel::go_to() {
    disarm();
    move_->open_here();
}

void JogPanel::turn_spindle() {
    Command command{};
    command.kind = CommandKind::spindle;
    command.value = context_.machine.view().is_active(Signal::spindle) ? 0.0 : 1.0;
    context_.machine.order(command, session::phrase("Spindle"));
}

void JogPanel::arm() {
    // Nothing that takes keys for itself.
    if (QWidget* focus = QApplication::focusWidget(); is_text_field(focus)) focus->clearFocus();
    keyboard_.arm(KeyboardJog::Clock::now());
    qApp->installEventFilter(this);
    show_armed();
}

void JogPanel::disarm() {
    if (!keyboard_.is_armed()) return;
    qApp->removeEventFilter(this);
    follow(keyboard_.disarm());
    show_armed();
}

void JogPanel::show_armed() {
    const bool is_armed = keyboard_.is_armed();
    set_styled(this, "jog_armed", is_armed ? "yes" : "no");
    if (on_armed_) on_armed_(is_armed);
    more_->setCurrentIndex(is_armed ? 1 : 0);
    arm_->setText(is_armed ? tr("Disarm keyboard jog") : tr("Arm keyboard jog"));
    // A new text takes the shortcut away.
    arm_->setShortcut(Qt::Key_F9);
    refresh();
}

void JogPanel::follow(const KeyboardJog::Order& order) {
    using Kind = KeyboardJog::Order::Kind;
    const auto [axis, up] = order.way;
    switch (order.kind) {
        case Kind::step:
            return context_.machine.jog().step(axis, up ? step_of(axis) : -step_of(axis), speed_of(axis));
        case Kind::hold:
            return context_.machine.jog().hold(axis, up, speed_of(axis));
        case Kind::release:
            return context_.machine.jog().release();
        case Kind::none:
            return;
    }
}

bool JogPanel::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    const bool is_key =
        type == QEvent::KeyPress || type == QEvent::KeyRelease || type == QEvent::ShortcutOverride;
    // A key comes through the native window first, and then through widgets.
    if (!is_key || !watched->isWidgetType() || !keyboard_.is_armed())
        return Dock::eventFilter(watched, event);
    const auto* pressed = static_cast<QKeyEvent*>(event);
    const auto key = jog_key(pressed->key());
    const bool is_ours = key && open_dialog() == nullptr && QApplication::activePopupWidget() == nullptr &&
                         !is_text_field(static_cast<QWidget*>(watched));
    if (!is_ours) return Dock::eventFilter(watched, event);
    const auto now = KeyboardJog::Clock::now();
    if (type == QEvent::KeyPress) {
        const Qt::KeyboardModifiers with = pressed->modifiers();
        follow(keyboard_.press({*key, with.testFlag(Qt::ControlModifier), with.testFlag(Qt::ShiftModifier),
                                pressed->isAutoRepeat()},
                               now));
    } else if (type == QEvent::KeyRelease) {
        follow(keyboard_.release(*key, pressed->isAutoRepeat(), now));
    }
    event->accept();
    return true;
}

}  // namespace psicarve::ui
