// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/choice_box.hpp"

#include <QPainter>

namespace psicarve::ui {

void ChoiceBox::paintEvent(QPaintEvent* event) {
    QComboBox::paintEvent(event);
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen{palette().color(QPalette::Text), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
    const QPointF at{width() - 13.0, height() / 2.0 + 2.0};
    const QPointF arrow[] = {at + QPointF{-4, -4}, at, at + QPointF{4, -4}};
    painter.drawPolyline(arrow, 3);
}

}  // namespace psicarve::ui
