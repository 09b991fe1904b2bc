// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/lock_with.hpp"

#include <QWidget>

namespace psicarve::ui {

void lock_with(QWidget& control, const QString& reason, const QString& hint) {
    control.setEnabled(reason.isEmpty());
    const QString& tip = reason.isEmpty() ? hint : reason;
    if (control.toolTip() != tip) control.setToolTip(tip);
    if (control.accessibleDescription() != tip) control.setAccessibleDescription(tip);
}

}  // namespace psicarve::ui
