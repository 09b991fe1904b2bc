// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPushButton;

namespace psicarve::ui {

/// What is checked is bold, which is wider: the button keeps room for it.
void leave_room_for_bold(QPushButton& button);

}  // namespace psicarve::ui
