// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/first_touch.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QWidget>
#include <QWindow>

namespace psicarve::ui {
namespace {

bool is_touch(const QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::TouchBegin:
        case QEvent::Wheel:
        case QEvent::KeyPress:
        case QEvent::ShortcutOverride:
        case QEvent::Drop:
            return true;
        default:
            return false;
    }
}

}  // namespace

FirstTouch::FirstTouch(const QWidget& window) : window_(window) {
    qApp->installEventFilter(this);
}

/// Menus and frames of panels are windows of their own, and children of this one. Keys that stop the machine
/// come no further than the screen's window.
bool FirstTouch::is_ours(const QObject& watched) const {
    if (&watched == window_.windowHandle()) return true;
    for (const QObject* at = &watched; at != nullptr; at = at->parent()) {
        if (at == &window_) return true;
    }
    return false;
}

bool FirstTouch::eventFilter(QObject* watched, QEvent* event) {
    if (is_touch(*event) && is_ours(*watched)) {
        has_come_ = true;
        qApp->removeEventFilter(this);
    }
    return false;
}

}  // namespace psicarve::ui
