// SPDX-License-Identifier: GPL-3.0-or-later
// Linked into psicarve-hmi as it is, this tells a test on the other end of a pipe what stands where on the
// screen. It never acts for the operator: what the test does, it does with the mouse and the keyboard. It can
// take memory away from OpenGL, which no operator does.
#include <unistd.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QPixmap>
#include <QPointer>
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
    if (const auto* const edit = qobject_cast<const QLineEdit*>(&widget)) return edit->text();
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

/// A widget, and the part of it that is meant.
struct Target {
    QPointer<QWidget> widget;
    QRect part;
};

/// tab N: of the tabs; dialog TEXT: the button of the question that is open; else a widget's name.
Target target_of(const QStringList& words) {
    if (words.value(1) == "tab") {
        auto* const window = widget_named("window");
        auto* const tabs = window != nullptr ? window->findChild<QTabWidget*>() : nullptr;
        if (tabs == nullptr) return {};
        return {tabs->tabBar(), tabs->tabBar()->tabRect(words.value(2).toInt())};
    }
    if (words.value(1) == "dialog") {
        auto* const box = qobject_cast<QMessageBox*>(psicarve::ui::open_dialog());
        if (box == nullptr) return {};
        const QString said = words.mid(2).join(' ');
        for (QAbstractButton* button : box->buttons()) {
            if (button->text() == said) return {button, button->rect()};
        }
        return {};
    }
    QWidget* const widget = widget_named(words.value(1));
    return widget != nullptr ? Target{widget, widget->rect()} : Target{};
}

QString where(const QStringList& words) {
    const Target target = target_of(words);
    return target.widget != nullptr ? place_of(*target.widget, target.part) : "none";
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

/// Takes a picture of the screen, or of the window of that name.
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

/// What the mouse has met since the test aimed at something: of each kind of event the first widget.
class Touch : public QObject {
public:
    using QObject::QObject;
    void aim_at(const QStringList& words) {
        target_ = target_of(words);
        met_.clear();
    }
    /// "it", "other" and what it was, or "none" so far.
    QString met(const QString& kind) const { return met_.value(kind, "none"); }

protected:
    bool eventFilter(QObject* receiver, QEvent* event) override {
        const QString kind = kind_of(*event);
        if (kind.isEmpty()) return false;
        if (receiver->isWindowType()) {
            is_fresh_ = true;  // from the screen; then it goes to a widget, and on to its parents
        } else if (auto* const widget = qobject_cast<QWidget*>(receiver); widget != nullptr && is_fresh_) {
            is_fresh_ = false;
            const QPoint place = static_cast<QSinglePointEvent*>(event)->globalPosition().toPoint();
            if (!met_.contains(kind)) met_[kind] = verdict(*widget, place);
        }
        return false;
    }

private:
    static QString kind_of(const QEvent& event) {
        switch (event.type()) {
            case QEvent::MouseButtonPress:
            case QEvent::MouseButtonDblClick:
                return "press";
            case QEvent::MouseButtonRelease:
                return "release";
            case QEvent::Wheel:
                return "wheel";
            default:
                return {};
        }
    }
    QString verdict(const QWidget& met, const QPoint& place) const {
        const QWidget* const wanted = target_.widget;
        const bool is_it = wanted != nullptr && (&met == wanted || wanted->isAncestorOf(&met)) &&
                           met.isEnabled() && target_.part.contains(wanted->mapFromGlobal(place));
        if (is_it) return "it";
        const char* const kind = qobject_cast<const QAbstractButton*>(&met) != nullptr ? "button" : "thing";
        return QString{"other %1 %2 %3"}.arg(kind, met.metaObject()->className(), met.objectName());
    }

    Target target_;
    bool is_fresh_ = false;
    QHash<QString, QString> met_;
};

Touch& touch() {
    static auto* const the_only = new Touch{qApp};
    return *the_only;
}

QString answer(const QString& question) {
    const QStringList words = question.split(' ');
    if (words[0] == "where") return where(words);
    if (words[0] == "aim") {
        touch().aim_at(words);
        return where(words);
    }
    if (words[0] == "met") return touch().met(words.value(1));
    const QDialog* const modal = psicarve::ui::open_dialog();
    // Active or not: its list of names may be up.
    if (words[0] == "open_dialog") return modal != nullptr ? modal->windowTitle() : "none";
    if (words[0] == "modal") {
        return modal != nullptr && modal->isActiveWindow() ? modal->windowTitle() : "none";
    }
    if (words[0] == "keyboard") {
        const QWidget* const holder = QApplication::activeWindow();
        return holder != nullptr && holder->isVisible() ? "here" : "elsewhere";
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
    qApp->installEventFilter(&touch());
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
