// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/session/machine_session.hpp"

class QWidget;

namespace psicarve::ui {

struct WindowContext;

/// Asks whether the published job is to begin with this place, which is not its first layer's begin, and says
/// on which way the heads come there. True: yes, and it may still be started.
bool asked_to_start_from(const WindowContext& context, const session::StartPlace& place,
                         session::RunKind kind, QWidget* window);

}  // namespace psicarve::ui
