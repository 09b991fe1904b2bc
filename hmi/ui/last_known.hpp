// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "hmi/session/machine_view.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {

/// "last known 14:58:07": when what is shown of a core that is not heard was so.
inline QString last_known(const session::MachineView& view) {
    if (view.status_time.time_since_epoch().count() == 0)
        return QCoreApplication::translate("ui", "last known");
    return QCoreApplication::translate("ui", "last known %1").arg(local_time(view.status_time, "HH:mm:ss"));
}

}  // namespace psicarve::ui
