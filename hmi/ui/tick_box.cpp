// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/tick_box.hpp"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionButton>

#include "hmi/ui/icon.hpp"

namespace psicarve::ui {

QRect TickBox::box() const {
    QStyleOptionButton option;
    initStyleOption(&option);
    return style()->subElementRect(QStyle::SE_CheckBoxIndicator, &option, this);
}

void TickBox::paintEvent(QPaintEvent* event) {
    QCheckBox::paintEvent(event);
    if (!isChecked()) return;
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    const QRect place = box();
    painter.translate(place.topLeft());
    draw_glyph(painter, Glyph::check, place.width(), palette().color(QPalette::WindowText));
}

}  // namespace psicarve::ui
