// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <functional>
#include <optional>

#include "hmi/session/action_lock.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

namespace psicarve::ui {

/// A button that asks for something, and says why when it cannot. What may start motion is never pressed by
/// Space or Enter: the focus may happen to be there. It takes the focus from the Tab key only, to be read.
class ActionButton : public QPushButton {
public:
    /// What stands in the way of it; nothing when it can be asked for.
    using LockOf = std::function<std::optional<session::Phrase>(const WindowContext&)>;

    /// For what is no Action: something of one axis, of one page.
    ActionButton(LockOf lock_of, const QString& text, std::function<void()> act, QWidget* parent = nullptr);
    /// Without a glyph the button has words alone.
    ActionButton(session::Action action, const QString& text, std::function<void()> act,
                 QWidget* parent = nullptr);

    /// It only ends motion: it may be pressed by a key.
    void let_keys_press() noexcept { may_move_ = false; }
    void set_glyph(Glyph glyph, const Tokens& tokens, bool on_fill = false);
    /// Locks or unlocks it. Why it is locked, in the operator's language; else empty.
    const QString& refresh(const WindowContext& context);
    const QString& reason() const noexcept { return reason_; }
    /// What it does, shown while it can.
    void set_hint(const QString& hint) { hint_ = hint; }

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    LockOf lock_of_;
    bool may_move_ = true;
    QString reason_;
    QString hint_;
};

}  // namespace psicarve::ui
