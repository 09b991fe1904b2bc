// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

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
MotionButtons make_motion_buttons(Bench& bench);

}  // namespace psicarve::ui
