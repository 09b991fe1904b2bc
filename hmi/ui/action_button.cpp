// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/action_button.hpp"

#include <QKeyEvent>

#include <utility>

#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

bool may_start_motion(session::Action action) {
    using A = session::Action;
    return action != A::hold && action != A::stop && action != A::slice && action != A::publish &&
           action != A::override_feed && action != A::reset_alarm;
}

}  // namespace

ActionButton::ActionButton(session::Action action, const QString& text, std::function<void()> act,
                           QWidget* parent)
    : ActionButton(
          [action](const WindowContext& context) {
              return session::lock_of(action, context.machine.view(), context.open_job.view());
          },
          text, std::move(act), parent) {
    may_move_ = may_start_motion(action);
}

ActionButton::ActionButton(LockOf lock_of, const QString& text, std::function<void()> act, QWidget* parent)
    : QPushButton(text, parent), lock_of_(std::move(lock_of)) {
    setFocusPolicy(Qt::TabFocus);
    setAutoDefault(false);
    if (act) QObject::connect(this, &QPushButton::clicked, this, [act = std::move(act)] { act(); });
}

void ActionButton::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    const bool presses =
        key == Qt::Key_Space || key == Qt::Key_Select || key == Qt::Key_Return || key == Qt::Key_Enter;
    if (may_move_ && presses) return event->ignore();
    QPushButton::keyPressEvent(event);
}

void ActionButton::set_glyph(Glyph glyph, const Tokens& tokens, bool on_fill) {
    setIcon(glyph_icon(glyph, on_fill ? tokens.on_fill : tokens.text, tokens.dis));
}

const QString& ActionButton::refresh(const WindowContext& context) {
    const auto lock = context.replay.is_open() ? replay::lock() : lock_of_(context);
    const QString reason = lock ? words(*lock) : QString{};
    lock_with(*this, reason, hint_);
    reason_ = reason;
    return reason_;
}

}  // namespace psicarve::ui
