// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/lock_with.hpp"

#include <QWidget>

#include "hmi/ui/frames.hpp"

namespace psicarve::ui {

void lock_with(QWidget& control, const QString& reason, const QString& hint) {
    control.setEnabled(reason.isEmpty());
    const QString& tip = reason.isEmpty() ? hint : reason;
    set_plain_tip(control, tip);
    if (control.accessibleDescription() != tip) control.setAccessibleDescription(tip);
}

}  // namespace psicarve::ui
