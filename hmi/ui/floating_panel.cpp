// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/floating_panel.hpp"

#include <QCloseEvent>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

namespace psicarve::ui {

FloatingPanel::FloatingPanel(QWidget& panel, const QString& title, QWidget* owner,
                             std::function<void()> put_back, std::function<void()> left)
    : QWidget(owner, Qt::Tool), put_back_(std::move(put_back)), left_(std::move(left)) {
    setWindowTitle(title);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(&panel);
    panel.show();
}

void FloatingPanel::closeEvent(QCloseEvent* event) {
    event->ignore();
    // It goes with what it was for, but not while it is being closed.
    auto* later = new QTimer{this};
    later->setSingleShot(true);
    connect(later, &QTimer::timeout, this, [this] { put_back_(); });
    later->start();
}

void FloatingPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::ActivationChange && !isActiveWindow()) left_();
    QWidget::changeEvent(event);
}

}  // namespace psicarve::ui
