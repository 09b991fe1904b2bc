// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/ui/press_log.hpp"

#include <QAbstractButton>
#include <QAction>
#include <QActionEvent>
#include <QApplication>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>

namespace psicarve::ui::test {
namespace {

constexpr const char* kHeard = "press_log_hears_it";

/// Once for each: it may be shown, and added, again and again.
bool is_heard_already(QObject& object) {
    const bool was = object.property(kHeard).isValid();
    object.setProperty(kHeard, true);
    return was;
}

}  // namespace

PressLog& PressLog::instance() {
    static auto* const log = new PressLog;  // the application owns it
    return *log;
}

PressLog::PressLog() : QObject(qApp) {
    qApp->installEventFilter(this);
}

void PressLog::hear_first() {
    qApp->removeEventFilter(this);
    qApp->installEventFilter(this);
}

void PressLog::forget() {
    pressed_.clear();
    seen_.clear();
}

std::string PressLog::name_of(const QObject& button, const QString& text) {
    return (button.objectName().isEmpty() ? "nameless: " + text : button.objectName()).toStdString();
}

bool PressLog::is_of_qt(const QObject& button) {
    if (button.objectName().startsWith("qt_") || button.inherits("QTableCornerButton")) return true;
    for (const QObject* at = button.parent(); at != nullptr; at = at->parent()) {
        if (qobject_cast<const QFileDialog*>(at) != nullptr || qobject_cast<const QTabBar*>(at) != nullptr ||
            at->inherits("QLineEdit") || at->inherits("QCustomPlot"))
            return true;
    }
    return false;
}

bool PressLog::is_for_table(const QAbstractButton& button) {
    const auto* const push = qobject_cast<const QPushButton*>(&button);
    const bool has_entries = push != nullptr && push->menu() != nullptr;
    const bool is_of_test = button.window()->objectName().startsWith("test_");
    return !has_entries && !is_of_test && !is_of_qt(button);
}

void PressLog::hear_button(QObject& widget) {
    auto* const button = qobject_cast<QAbstractButton*>(&widget);
    if (button == nullptr || is_of_qt(*button) || is_heard_already(*button)) return;
    const auto note = [this, button] { pressed_.insert(name_of(*button, button->text())); };
    connect(button, &QAbstractButton::pressed, this, note);
    connect(button, &QAbstractButton::clicked, this, note);
}

void PressLog::hear_action(QAction& action) {
    if (action.isSeparator() || action.menu() != nullptr || is_of_qt(action)) return;
    if (is_heard_already(action)) return;
    connect(&action, &QAction::triggered, this,
            [this, &action] { pressed_.insert(name_of(action, action.text())); });
}

bool PressLog::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Polish:
            hear_button(*watched);
            break;
        case QEvent::Show:
            if (const auto* button = qobject_cast<QAbstractButton*>(watched); button && is_for_table(*button))
                seen_.insert(name_of(*button, button->text()));
            break;
        case QEvent::ActionAdded:
            hear_action(*static_cast<QActionEvent*>(event)->action());
            break;
        case QEvent::KeyPress:
        case QEvent::ShortcutOverride: {
            const auto* key = static_cast<QKeyEvent*>(event);
            if (!watched->isWidgetType()) break;
            pressed_.insert(
                QKeySequence{key->keyCombination()}.toString(QKeySequence::PortableText).toStdString());
            break;
        }
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace psicarve::ui::test
