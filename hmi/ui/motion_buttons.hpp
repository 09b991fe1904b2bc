// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "hmi/session/machine_view.hpp"
#include "hmi/ui/action_button.hpp"

namespace psicarve::ui {

/// Start, Hold, Resume and Stop, wherever they stand.
struct MotionButtons {
    ActionButton* start;
    ActionButton* hold;
    ActionButton* resume;
    ActionButton* stop;

    std::array<ActionButton*, 4> all() const noexcept { return {start, hold, resume, stop}; }
};
MotionButtons make_motion_buttons(WindowContext& context);
/// The one thing to be said beside them: why Start is locked, else why the others are. Empty: nothing is.
QString why_locked(const MotionButtons& buttons);
/// The same, and where Start works what should be looked at before; empty: nothing.
QString said_beside(const MotionButtons& buttons, const QString& to_look_at);
/// What Start begins with; nothing: with the first layer.
std::optional<session::StartPlace> place_to_begin_with(const WindowContext& context);
/// Start says what it would start: the job, what is left of it, or a dry run.
void show_what_starts(ActionButton& start, const WindowContext& context);

}  // namespace psicarve::ui
