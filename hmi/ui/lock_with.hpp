// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace psicarve::ui {

/// Locks what has a reason against it, which tooltip and accessible description then tell; without one they
/// tell the hint, and it can be used.
void lock_with(QWidget& control, const QString& reason, const QString& hint = {});

}  // namespace psicarve::ui
