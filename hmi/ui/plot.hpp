// SPDX-License-Identifier: GPL-3.0-or-later
// QCustomPlot, whose header wants Qt's keywords; elsewhere they stay off (QT_NO_KEYWORDS).
#pragma once

#include <QtGlobal>

#define signals Q_SIGNALS
#define slots Q_SLOTS
#define foreach Q_FOREACH
#define emit Q_EMIT
#include <qcustomplot.h>
#undef signals
#undef slots
#undef foreach
#undef emit
