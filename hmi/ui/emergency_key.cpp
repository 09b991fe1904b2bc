// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/emergency_key.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QWindow>
#include <utility>

namespace psicarve::ui {

MainWindow::EmergencyKey::EmergencyKey(std::function<void()> act) : act_(std::move(act)) {
    qApp->installEventFilter(this);
}

bool MainWindow::EmergencyKey::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return QObject::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() != Qt::Key_F1) return QObject::eventFilter(watched, event);
    // A key comes as several events, through the native window and through widgets: it acts once, on the
    // first widget.
    if (event->type() == QEvent::KeyPress && watched->isWidgetType() && !key->isAutoRepeat()) {
        act_();
        return true;
    }
    return watched->isWidgetType();
}

}  // namespace psicarve::ui
