// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/notice_bar.hpp"

#include <QAbstractButton>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/text_room.hpp"

namespace psicarve::ui {
namespace {

constexpr int kNoticeIconSide = 24;
constexpr int kNoticeIconWidth = 40;
constexpr int kBetweenLines = 3;

}  // namespace

NoticeBar::NoticeBar(const char* name, Glyph glyph, QWidget* parent)
    : QFrame(parent),
      glyph_(glyph),
      icon_(new QLabel),
      title_(role_label("title")),
      text_(new TextRoom),
      buttons_(new QVBoxLayout) {
    setObjectName(name);
    setProperty("notice", true);
    title_->setObjectName(objectName() + "_title");
    title_->setWordWrap(true);
    icon_->setFixedWidth(kNoticeIconWidth);
    icon_->setAlignment(Qt::AlignCenter);
    text_->setObjectName(objectName() + "_room");
    text_->column().setContentsMargins(0, kGap, kGap, kGap);
    text_->column().setSpacing(kBetweenLines);
    text_->column().addWidget(title_);
    buttons_->setContentsMargins(0, kSmallGap, 0, kSmallGap);
    buttons_->setSpacing(kSmallGap);
    buttons_->addStretch();
    buttons_->addStretch();
    auto* all = new QHBoxLayout{this};
    all->setContentsMargins(0, 0, kGap, 0);
    all->setSpacing(0);
    all->addWidget(icon_);
    all->addWidget(text_, 1);
    all->addLayout(buttons_);
    setVisible(false);
}

QLabel* NoticeBar::add_text(const char* part) {
    auto* label = plain_label();
    label->setObjectName(objectName() + '_' + part);
    label->setWordWrap(true);
    text_->column().addWidget(label);
    return label;
}

void NoticeBar::add_button(QAbstractButton* button) {
    buttons_->insertWidget(buttons_->count() - 1, button);
}

void NoticeBar::add_buttons(QLayout* group) {
    buttons_->insertLayout(buttons_->count() - 1, group);
}

void NoticeBar::set_theme(const Tokens& tokens) {
    icon_->setPixmap(glyph_pixmap(glyph_, kNoticeIconSide, tokens.warn));
    refresh();
}

void NoticeBar::set_shown(bool is_shown) {
    if (isHidden() == is_shown) setVisible(is_shown);
}

void NoticeBar::show_text(QLabel& label, const QString& text) {
    if (label.text() != text) {
        label.setText(text);
        if (&label == title_) text_->show_top();  // it is about something else
    }
    if (label.isHidden() != text.isEmpty()) label.setHidden(text.isEmpty());
}

}  // namespace psicarve::ui
