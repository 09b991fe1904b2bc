// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/elided_label.hpp"

#include <QPainter>

namespace psicarve::ui {

void ElidedLabel::show_text(const QString& new_text) {
    if (text() == new_text) return;
    setText(new_text);
    setToolTip(new_text);
}

QSize ElidedLabel::minimumSizeHint() const {
    return {0, QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter{this};
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(contentsRect(), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideMiddle, contentsRect().width()));
}

}  // namespace psicarve::ui
