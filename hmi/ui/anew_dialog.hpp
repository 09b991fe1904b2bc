// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace psicarve::ui {

struct Bench;

/// Asks whether the published job, of which something is carved, is to begin with its first layer, with a
/// picture of what is carved. True: yes, and it may still be started.
bool asked_to_begin_anew(const Bench& bench, QWidget* window);

}  // namespace psicarve::ui
