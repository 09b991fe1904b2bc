// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/place_keeper.hpp"

#include <QEvent>
#include <QWidget>

#include <chrono>
#include <utility>

namespace psicarve::ui {
namespace {

/// A window that is being dragged changes with every frame; a file is not written so often.
constexpr std::chrono::milliseconds kQuiet{300};

}  // namespace

PlaceKeeper::PlaceKeeper(std::function<void()> keep) {
    soon_.setSingleShot(true);
    soon_.setInterval(kQuiet);
    connect(&soon_, &QTimer::timeout, this, [keep = std::move(keep)] { keep(); });
}

void PlaceKeeper::watch(QWidget& window) {
    window.installEventFilter(this);
}

bool PlaceKeeper::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::Resize || type == QEvent::Move || type == QEvent::WindowStateChange) keep_soon();
    return QObject::eventFilter(watched, event);
}

}  // namespace psicarve::ui
