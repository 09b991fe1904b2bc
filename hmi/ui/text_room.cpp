// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/text_room.hpp"

#include <QEvent>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace psicarve::ui {
namespace {

constexpr int kLeastTextRoomHeight = 60;  // the title, and the first line of what is below it
constexpr int kLeastTextRoomWidth = 80;

}  // namespace

TextRoom::TextRoom(QWidget* parent) : QScrollArea(parent) {
    setProperty("text_room", true);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    auto* const inside = new QWidget;
    column_ = new QVBoxLayout{inside};
    setWidget(inside);
}

void TextRoom::show_top() {
    verticalScrollBar()->setValue(0);
}

/// Beside a scroll bar lines are shorter; then all of them is scrolled anyway.
void TextRoom::refresh_height() {
    const int needed = column_->totalHeightForWidth(std::max(1, contentsRect().width()));
    if (needed == full_height_) return;
    full_height_ = needed;
    updateGeometry();
}

QSize TextRoom::sizeHint() const {
    return {column_->totalSizeHint().width(), full_height_};
}

QSize TextRoom::minimumSizeHint() const {
    return {kLeastTextRoomWidth, std::min(kLeastTextRoomHeight, full_height_)};
}

bool TextRoom::eventFilter(QObject* watched, QEvent* event) {
    const bool is_handled = QScrollArea::eventFilter(watched, event);
    if (watched == widget() && event->type() == QEvent::LayoutRequest) refresh_height();
    return is_handled;
}

void TextRoom::resizeEvent(QResizeEvent* event) {
    refresh_height();
    QScrollArea::resizeEvent(event);
}

}  // namespace psicarve::ui
