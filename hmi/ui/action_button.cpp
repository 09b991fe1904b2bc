// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/action_button.hpp"

#include <utility>

#include "hmi/ui/words.hpp"

namespace psicarve::ui {

ActionButton::ActionButton(session::Action action, const QString& text, std::function<void()> act,
                           QWidget* parent)
    : QPushButton(text, parent), action_(action) {
    setFocusPolicy(Qt::TabFocus);
    setAutoDefault(false);
    if (act) QObject::connect(this, &QPushButton::clicked, this, [act = std::move(act)] { act(); });
}

void ActionButton::set_glyph(Glyph glyph, const Tokens& tokens, bool on_fill) {
    setIcon(glyph_icon(glyph, on_fill ? tokens.on_fill : tokens.text, tokens.dis));
}

const QString& ActionButton::refresh(const Bench& bench) {
    const auto lock = session::lock_of(action_, bench.machine.sight(), bench.desk.sight());
    const QString reason = lock ? words(*lock) : QString{};
    setEnabled(!lock);
    const QString& tip = lock ? reason : hint_;
    if (toolTip() != tip) setToolTip(tip);
    if (accessibleDescription() != tip) setAccessibleDescription(tip);
    reason_ = reason;
    return reason_;
}

}  // namespace psicarve::ui
