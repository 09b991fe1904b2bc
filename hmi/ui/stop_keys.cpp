// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/stop_keys.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <utility>

#include "hmi/ui/dialogs.hpp"

namespace psicarve::ui {
namespace {

bool keeps_escape(const QObject& watched) {
    const auto* const widget = qobject_cast<const QWidget*>(&watched);
    return widget != nullptr && widget->window()->property(kKeepsEscape).toBool();
}

}  // namespace

MainWindow::StopKeys::StopKeys(std::function<void()> emergency_stop, std::function<bool()> may_stop,
                               std::function<void()> stop)
    : emergency_stop_(std::move(emergency_stop)), may_stop_(std::move(may_stop)), stop_(std::move(stop)) {
    qApp->installEventFilter(this);
}

const std::function<void()>* MainWindow::StopKeys::action_of(int key, const QObject& watched) const {
    if (key == Qt::Key_F1) return &emergency_stop_;
    return key == Qt::Key_Escape && !keeps_escape(watched) && may_stop_() ? &stop_ : nullptr;
}

bool MainWindow::StopKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return QObject::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const auto* const act = action_of(key->key(), *watched);
    if (act == nullptr) return QObject::eventFilter(watched, event);
    // A key comes as several events, through the native window and through widgets: it acts once, on the
    // first widget.
    if (event->type() == QEvent::KeyPress && watched->isWidgetType() && !key->isAutoRepeat()) {
        (*act)();
        return true;
    }
    return watched->isWidgetType();
}

}  // namespace psicarve::ui
