// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

class QWidget;

namespace psicarve::ui {

struct WindowContext;

/// Asks whether the published job is to go on from this layer, counted from 0, where only a disk knows that
/// the layers before it are carved: date, tool and profile are shown. True: yes, and it may still be started;
/// unasked where the machine itself knows it. The piece may be forgotten there, too.
bool asked_to_go_on_from_disk(WindowContext& context, std::uint32_t layer, QWidget* window);

/// Forgets the unfinished piece for good, once asked.
void forget_when_asked(WindowContext& context, QWidget* window);

}  // namespace psicarve::ui
