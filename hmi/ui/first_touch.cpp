// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/first_touch.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QWidget>
#include <QWindow>

namespace psicarve::ui {
namespace {

/// A desktop needs two for a place and a size of its own, each.
constexpr int kMovesOfAHand = 6;

bool is_touch(const QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::TouchBegin:
        case QEvent::Wheel:
        case QEvent::KeyPress:
        case QEvent::ShortcutOverride:
        case QEvent::Drop:
        case QEvent::NonClientAreaMouseButtonPress:
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

bool FirstTouch::is_drawn(const QObject& watched, const QEvent& event) {
    const bool is_move = event.type() == QEvent::Move || event.type() == QEvent::Resize;
    if (!is_move || &watched != &window_ || !window_.isVisible()) return false;
    return ++moves_ >= kMovesOfAHand;
}

bool FirstTouch::eventFilter(QObject* watched, QEvent* event) {
    if ((is_touch(*event) && is_ours(*watched)) || is_drawn(*watched, *event)) {
        has_come_ = true;
        qApp->removeEventFilter(this);
    }
    return false;
}

}  // namespace psicarve::ui
