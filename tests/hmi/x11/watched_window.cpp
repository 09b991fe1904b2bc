// SPDX-License-Identifier: GPL-3.0-or-later
// Linked into psicarve-hmi as it is, this tells a test on the other end of a pipe what stands where on the
// screen. It never acts for the operator: what the test does, it does with the mouse and the keyboard. It can
// take memory away from OpenGL, which no operator does.
#include <unistd.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QMessageBox>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QPixmap>
#include <QScreen>
#include <QSocketNotifier>
#include <QTabBar>
#include <QTabWidget>
#include <QTextStream>

#include <array>
#include <cstdio>
#include <limits>
#include <optional>

#include "hmi/ui/dialogs.hpp"

namespace {

QWidget* widget_named(const QString& name) {
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (window->objectName() == name) return window;
        if (auto* const found = window->findChild<QWidget*>(name)) return found;
    }
    return nullptr;
}

QString text_of(const QWidget& widget) {
    if (const auto* const label = qobject_cast<const QLabel*>(&widget)) return label->text();
    if (const auto* const button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
    return widget.accessibleName();
}

QString place_of(const QWidget& widget, const QRect& part) {
    const QPoint middle = widget.mapToGlobal(part.center());
    const bool is_ready = widget.isVisible() && widget.isEnabled() && widget.window()->isActiveWindow();
    return QString{"%1 %2 %3 %4"}
        .arg(middle.x())
        .arg(middle.y())
        .arg(part.width())
        .arg(is_ready ? "ready" : "not");
}

/// tab N: of the tabs; dialog TEXT: the button of the question that is open; else a widget's name.
QString where(const QStringList& words) {
    if (words.value(1) == "tab") {
        auto* const window = widget_named("window");
        auto* const tabs = window != nullptr ? window->findChild<QTabWidget*>() : nullptr;
        if (tabs == nullptr) return "none";
        return place_of(*tabs->tabBar(), tabs->tabBar()->tabRect(words.value(2).toInt()));
    }
    if (words.value(1) == "dialog") {
        auto* const box = qobject_cast<QMessageBox*>(psicarve::ui::open_dialog());
        if (box == nullptr) return "none";
        const QString said = words.mid(2).join(' ');
        for (const QAbstractButton* button : box->buttons()) {
            if (button->text() == said) return place_of(*button, button->rect());
        }
        return "none";
    }
    const QWidget* const widget = widget_named(words.value(1));
    return widget != nullptr ? place_of(*widget, widget->rect()) : "none";
}

/// Asks the driver for more than there is, in the context that the view draws with: its next frame fails.
QString exhaust(const QWidget& view) {
    for (QObject* child : view.children()) {
        auto* const canvas = qobject_cast<QOpenGLWidget*>(child);
        if (canvas == nullptr) continue;
        canvas->makeCurrent();
        auto* const gl = canvas->context()->functions();
        GLuint buffer = 0;
        gl->glGenBuffers(1, &buffer);
        gl->glBindBuffer(GL_ARRAY_BUFFER, buffer);
        gl->glBufferData(GL_ARRAY_BUFFER, std::numeric_limits<qopengl_GLsizeiptr>::max() / 2, nullptr,
                         GL_STATIC_DRAW);
        canvas->doneCurrent();
        canvas->update();
        return "exhausted";
    }
    return "none";
}

/// Of the screen, or of the window of that name.
bool picture(const QStringList& words) {
    if (words.size() < 3) return QGuiApplication::primaryScreen()->grabWindow(0).save(words.value(1));
    QWidget* const widget = widget_named(words[2]);
    return widget != nullptr && widget->grab().save(words[1]);
}

/// Where the window itself stands, and how.
QString place_of_window() {
    const QWidget* const part = widget_named("window");
    if (part == nullptr) return "none";
    const QWidget& window = *part->window();
    const QRect place = window.geometry();
    return QString{"%1 %2 %3 %4 %5"}
        .arg(place.x())
        .arg(place.y())
        .arg(place.width())
        .arg(place.height())
        .arg(window.isMaximized() ? "maximised" : "free");
}

QString answer(const QString& question) {
    const QStringList words = question.split(' ');
    if (words[0] == "where") return where(words);
    if (words[0] == "modal") {
        const QDialog* const modal = psicarve::ui::open_dialog();
        return modal != nullptr && modal->isActiveWindow() ? modal->windowTitle() : "none";
    }
    if (words[0] == "picture") return picture(words) ? "saved" : "none";
    if (words[0] == "place") return place_of_window();
    const QWidget* const widget = widget_named(words.value(1));
    if (words[0] == "current") {
        const auto* const tabs = qobject_cast<const QTabWidget*>(widget);
        return tabs != nullptr ? QString::number(tabs->currentIndex()) : "none";
    }
    if (words[0] == "text" && widget != nullptr && widget->isVisible()) return text_of(*widget);
    if (words[0] == "exhaust" && widget != nullptr) return exhaust(*widget);
    if (words[0] == "kind" && widget != nullptr) {
        // What draws a view of the space.
        for (const QObject* child : widget->children()) {
            if (child->inherits("QOpenGLWidget")) return "opengl";
        }
        return "painter";
    }
    return "none";
}

void listen() {
    auto* const ear = new QSocketNotifier{STDIN_FILENO, QSocketNotifier::Read, qApp};
    QObject::connect(ear, &QSocketNotifier::activated, qApp, [ear] {
        std::array<char, 4096> line{};
        if (std::fgets(line.data(), line.size(), stdin) == nullptr) return ear->setEnabled(false);
        const QString said = answer(QString::fromUtf8(line.data()).trimmed()).simplified();
        std::fprintf(stdout, "%s\n", said.toUtf8().constData());
        std::fflush(stdout);
    });
}

}  // namespace

Q_COREAPP_STARTUP_FUNCTION(listen)
