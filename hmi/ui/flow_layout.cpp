// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/flow_layout.hpp"

#include <QWidget>

#include <algorithm>

#include "hmi/ui/frames.hpp"

namespace psicarve::ui {

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {
    setContentsMargins(0, 0, 0, 0);
    setSpacing(kSmallGap);
}

FlowLayout::~FlowLayout() {
    for (QLayoutItem* item : items_) delete item;
}

void FlowLayout::addItem(QLayoutItem* item) {
    items_.push_back(item);
}

int FlowLayout::count() const {
    return static_cast<int>(items_.size());
}

QLayoutItem* FlowLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
    QLayoutItem* const item = itemAt(index);
    if (item != nullptr) items_.erase(items_.begin() + index);
    return item;
}

Qt::Orientations FlowLayout::expandingDirections() const {
    return Qt::Horizontal;
}

bool FlowLayout::hasHeightForWidth() const {
    return true;
}

std::vector<std::size_t> FlowLayout::visible() const {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (!items_[i]->isEmpty()) shown.push_back(i);
    }
    return shown;
}

std::vector<FlowLayout::Line> FlowLayout::lines(const std::vector<std::size_t>& shown, int width) const {
    std::vector<Line> made;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const QSize size = items_[shown[i]]->sizeHint();
        const bool fits = !made.empty() && made.back().width + spacing() + size.width() <= width;
        if (!fits) {
            made.push_back({i, i + 1, size.width(), size.height()});
            continue;
        }
        Line& line = made.back();
        line.end = i + 1;
        line.width += spacing() + size.width();
        line.height = std::max(line.height, size.height());
    }
    return made;
}

int FlowLayout::heightForWidth(int width) const {
    const QMargins around = contentsMargins();
    int height = around.top() + around.bottom();
    const auto made = lines(visible(), width - around.left() - around.right());
    for (const Line& line : made) height += line.height;
    return height + spacing() * std::max(0, static_cast<int>(made.size()) - 1);
}

void FlowLayout::setGeometry(const QRect& room) {
    QLayout::setGeometry(room);
    const QRect inside = room.marginsRemoved(contentsMargins());
    const auto shown = visible();
    int top = inside.top();
    for (const Line& line : lines(shown, inside.width())) {
        int left = inside.left();
        bool has_slack = true;
        for (std::size_t i = line.begin; i < line.end; ++i) {
            if (has_slack && shown[i] >= end_from_) {
                left += std::max(0, inside.width() - line.width);
                has_slack = false;
            }
            const QSize size = items_[shown[i]]->sizeHint().boundedTo({inside.width(), line.height});
            items_[shown[i]]->setGeometry({{left, top + (line.height - size.height()) / 2}, size});
            left += size.width() + spacing();
        }
        top += line.height + spacing();
    }
}

QSize FlowLayout::sizeHint() const {
    int width = 0;
    int height = 0;
    for (const std::size_t i : visible()) {
        const QSize size = items_[i]->sizeHint();
        width += size.width() + (width > 0 ? spacing() : 0);
        height = std::max(height, size.height());
    }
    const QMargins around = contentsMargins();
    return {width + around.left() + around.right(), height + around.top() + around.bottom()};
}

QSize FlowLayout::minimumSize() const {
    QSize least;
    for (const std::size_t i : visible()) least = least.expandedTo(items_[i]->sizeHint());
    const QMargins around = contentsMargins();
    return {least.width() + around.left() + around.right(), least.height() + around.top() + around.bottom()};
}

}  // namespace psicarve::ui
