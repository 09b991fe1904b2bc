// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/state_pill.hpp"

#include <QAccessible>
#include <QAccessibleEvent>
#include <QPainter>

#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kWidth = 200;
constexpr int kNarrowWidth = 156;
constexpr int kHeight = 48;
constexpr int kGlyphSide = 26;
constexpr int kTextLeft = 52;
constexpr double kCorner = 4.0;

}  // namespace

StatePill::StatePill(QWidget* parent) : QWidget(parent) {
    setFixedSize(kWidth, kHeight);
}

QSize StatePill::sizeHint() const {
    return size();
}

void StatePill::set_narrow(bool narrow) {
    setFixedSize(narrow ? kNarrowWidth : kWidth, kHeight);
}

void StatePill::show_state(const session::StateText& text, Glyph glyph, const Tokens& tokens) {
    const QString word = words(text.word);
    const QString second = words(text.second);
    const QColor fill = fill_of(tokens, text.tone);
    if (word == word_ && second == second_ && fill == fill_ && glyph == glyph_) return;
    const bool is_new_state = word != word_;
    word_ = word;
    second_ = second;
    glyph_ = glyph;
    fill_ = fill;
    ink_ = ink_of(tokens, text.tone);
    setAccessibleName(word_ + ", " + second_);
    if (is_new_state) {
        QAccessibleEvent event{this, QAccessible::NameChanged};
        QAccessible::updateAccessibility(&event);
    }
    update();
}

void StatePill::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill_);
    painter.drawRoundedRect(rect(), kCorner, kCorner);
    painter.save();
    painter.translate((kTextLeft - kGlyphSide) / 2.0, (height() - kGlyphSide) / 2.0);
    draw_glyph(painter, glyph_, kGlyphSide, ink_);
    painter.restore();
    painter.setPen(ink_);
    QFont big = font();
    big.setPixelSize(word_.size() > 10 ? 15 : 18);
    big.setBold(true);
    painter.setFont(big);
    const QRect upper{kTextLeft, 4, width() - kTextLeft - 4, 24};
    painter.drawText(upper, Qt::AlignLeft | Qt::AlignVCenter, word_);
    QFont small = font();
    small.setPixelSize(12);
    painter.setFont(small);
    const QRect lower{kTextLeft, 26, width() - kTextLeft - 4, 18};
    painter.drawText(lower, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(second_, Qt::ElideRight, lower.width()));
}

}  // namespace psicarve::ui
