// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/stop_keys.hpp"

#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QMenuBar>
#include <utility>

namespace psicarve::ui {
namespace {

/// Dialogs, menus, lists that drop down: Esc closes them.
bool has_its_own_escape(const QObject& watched) {
    if (QApplication::activePopupWidget() != nullptr) return true;
    const auto* const widget = qobject_cast<const QWidget*>(&watched);
    if (widget == nullptr) return false;
    return qobject_cast<const QMenuBar*>(widget) != nullptr ||
           qobject_cast<const QDialog*>(widget->window()) != nullptr;
}

}  // namespace

MainWindow::StopKeys::StopKeys(Acts acts) : acts_(std::move(acts)) {
    qApp->installEventFilter(this);
}

std::function<void()> MainWindow::StopKeys::action_of(const QKeyEvent& key, const QObject& watched) const {
    if (key.key() == Qt::Key_F1) return acts_.emergency_stop;
    if (key.key() != Qt::Key_Escape) return {};
    if (key.modifiers().testFlag(Qt::ShiftModifier)) return acts_.may_stop() ? acts_.stop : nullptr;
    if (key.modifiers() != Qt::NoModifier || has_its_own_escape(watched)) return {};
    return acts_.escape();
}

bool MainWindow::StopKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return QObject::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const auto act = action_of(*key, *watched);
    if (!act) return QObject::eventFilter(watched, event);
    // A key comes as several events, through the native window and through widgets: it acts once, on the
    // first widget.
    if (event->type() == QEvent::KeyPress && watched->isWidgetType() && !key->isAutoRepeat()) {
        act();
        return true;
    }
    return watched->isWidgetType();
}

}  // namespace psicarve::ui
