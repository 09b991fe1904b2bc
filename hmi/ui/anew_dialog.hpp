// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/session/machine_session.hpp"

class QMessageBox;
class QPushButton;
class QWidget;

namespace psicarve::ui {

struct WindowContext;

/// Asks whether the published job is to begin with its first layer though a piece of it was begun, with a
/// picture of what is carved. True: yes, and it may still be started; unasked where there is no such piece.
bool asked_to_begin_anew(const WindowContext& context, session::RunKind kind, QWidget* window);

/// Shows the box, and closes it as soon as what it asks is no more so: another job or another state of its
/// piece, or the machine cannot start it from a layer. True: `go` was pressed while it was.
bool asked_of_this_piece(const WindowContext& context, QMessageBox& box, const QPushButton* go);

}  // namespace psicarve::ui
