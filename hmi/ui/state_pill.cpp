// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/state_pill.hpp"

#include <QAccessible>
#include <QAccessibleEvent>
#include <QPainter>
#include <QStringList>

#include <algorithm>

#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kWidth = 200;
constexpr int kNarrowWidth = 156;
constexpr int kWideWidth = 256;
constexpr int kHeight = 56;
constexpr int kLeastMargin = 2;  // above and below its lines
constexpr int kGlyphSide = 26;
constexpr int kTextLeft = 44;
constexpr int kTextRight = 4;
constexpr double kCorner = 4.0;
constexpr int kWordHeight = 18;
constexpr int kLowWordHeight = 15;
constexpr int kSecondHeight = 12;
constexpr int kLeastHeight = 11;  // nothing in the window is smaller

}  // namespace

StatePill::StatePill(QWidget* parent) : QWidget(parent) {
    setFixedSize(kWidth, kHeight);
}

QSize StatePill::sizeHint() const {
    return size();
}

void StatePill::set_room(Room room) {
    setFixedSize(room == Room::small ? kNarrowWidth : room == Room::wide ? kWideWidth : kWidth, kHeight);
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

/// As large as wanted, or as the room lets it be.
QFont StatePill::fitting(const QString& text, int height, bool is_bold) const {
    QFont chosen = font();
    chosen.setBold(is_bold);
    for (; height >= kLeastHeight; --height) {
        chosen.setPixelSize(height);
        if (QFontMetrics{chosen}.horizontalAdvance(text) < text_width()) break;
    }
    return chosen;
}

int StatePill::text_width() const {
    return width() - kTextLeft - kTextRight;
}

/// A second line that is too long becomes two, under a smaller word. All of them stand in the middle.
StatePill::Lines StatePill::lines() const {
    const QFont second = fitting(second_, kSecondHeight, false);
    const QFontMetrics small{second};
    const bool is_one_line = small.horizontalAdvance(second_) < text_width();
    const QFont word = fitting(word_, is_one_line ? kWordHeight : kLowWordHeight, true);
    const int upper = QFontMetrics{word}.height();
    const QRect room{0, 0, text_width(), kHeight};
    const int lower = small.boundingRect(room, Qt::TextWordWrap, second_).height();
    const int top = (kHeight - upper - lower) / 2;
    return {word, second, QRect{kTextLeft, top, text_width(), upper},
            QRect{kTextLeft, top + upper, text_width(), lower}};
}

bool StatePill::is_cut_off() const {
    const Lines now = lines();
    const QFontMetrics small{now.second};
    const QStringList parts = second_.split(' ');
    const bool is_part_too_long = std::any_of(parts.begin(), parts.end(), [&](const QString& part) {
        return small.horizontalAdvance(part) > text_width();
    });
    return QFontMetrics{now.word}.horizontalAdvance(word_) > text_width() || is_part_too_long ||
           now.upper.top() < kLeastMargin;
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
    const Lines now = lines();
    painter.setFont(now.word);
    painter.drawText(now.upper, Qt::AlignLeft | Qt::AlignVCenter, word_);
    painter.setFont(now.second);
    painter.drawText(now.lower, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, second_);
}

}  // namespace psicarve::ui
