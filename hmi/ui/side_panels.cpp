// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/side_panels.hpp"

#include <QGridLayout>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include "hmi/ui/frames.hpp"

namespace psicarve::ui {
namespace {

constexpr QSize kLeastForUsual{1100, 660};
constexpr int kLeastForWide = 1600;
constexpr int kLeftWidth = 256;
constexpr int kWideLeftWidth = 304;
constexpr int kRightWidth = 264;
constexpr int kWideRightWidth = 336;
constexpr int kStackWidth = 284;  // a panel and a scroll bar

QVBoxLayout* column_in(QWidget* widget) {
    auto* column = new QVBoxLayout{widget};
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap);
    return column;
}

}  // namespace

Room room_in(QSize window) {
    if (window.width() < kLeastForUsual.width() || window.height() < kLeastForUsual.height())
        return Room::small;
    return window.width() < kLeastForWide ? Room::usual : Room::wide;
}

MotionBlock::MotionBlock(Bench& bench) : bench_(bench), buttons_(make_motion_buttons(bench)) {
    setObjectName("motion");
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kSmallGap);
    int place = 0;
    for (ActionButton* button : buttons_.all()) {
        grid->addWidget(button, place / 2, place % 2);
        ++place;
    }
}

void MotionBlock::set_theme(const Tokens& tokens) {
    buttons_.start->set_glyph(Glyph::play, tokens);
    buttons_.hold->set_glyph(Glyph::pause, tokens);
    buttons_.resume->set_glyph(Glyph::play, tokens);
    buttons_.stop->set_glyph(Glyph::stop, tokens);
}

void MotionBlock::refresh() {
    for (ActionButton* button : buttons_.all()) button->refresh(bench_);
}

SidePanels::SidePanels(Bench& bench, QWidget* position, QWidget* jog, QWidget* job)
    : panels_{position, jog, job},
      left_(new QWidget),
      right_(new QWidget),
      left_column_(column_in(left_)),
      right_column_(column_in(right_)),
      names_(new QTabBar{left_}),
      stack_(new QStackedWidget{left_}),
      buttons_(new MotionBlock{bench}) {
    names_->setObjectName("side_names");
    names_->setDrawBase(false);
    stack_->setObjectName("side_pages");
    buttons_->setParent(left_);
    const QString names[] = {tr("Position"), tr("Jog"), tr("Job")};
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        pages_[i] = new QScrollArea;
        pages_[i]->setWidgetResizable(true);
        pages_[i]->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        names_->addTab(names[i]);
        stack_->addWidget(pages_[i]);
    }
    QObject::connect(names_, &QTabBar::currentChanged, stack_, &QStackedWidget::setCurrentIndex);
    spread(Room::usual);
}

bool SidePanels::arrange(Room room) {
    if (room == room_) return false;
    room_ = room;
    if (room == Room::small) {
        stack();
    } else {
        spread(room);
    }
    return true;
}

void SidePanels::stack() {
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        panels_[i]->setMinimumWidth(0);
        panels_[i]->setMaximumWidth(QWIDGETSIZE_MAX);
        pages_[i]->setWidget(panels_[i]);
        panels_[i]->show();
    }
    left_column_->addWidget(names_);
    left_column_->addWidget(stack_, 1);
    left_column_->addWidget(buttons_);
    left_->setFixedWidth(kStackWidth);
    for (QWidget* widget :
         {static_cast<QWidget*>(names_), static_cast<QWidget*>(stack_), static_cast<QWidget*>(buttons_)})
        widget->show();
    right_->hide();
}

void SidePanels::spread(Room room) {
    const bool is_wide = room == Room::wide;
    for (QScrollArea* page : pages_) page->takeWidget();
    left_column_->addWidget(panels_[0]);
    left_column_->addWidget(panels_[1], 1);
    right_column_->addWidget(panels_[2], 1);
    for (QWidget* panel : panels_) panel->show();
    for (QWidget* widget :
         {static_cast<QWidget*>(names_), static_cast<QWidget*>(stack_), static_cast<QWidget*>(buttons_)}) {
        left_column_->removeWidget(widget);
        widget->hide();
    }
    const int left_width = is_wide ? kWideLeftWidth : kLeftWidth;
    const int right_width = is_wide ? kWideRightWidth : kRightWidth;
    for (QWidget* widget : {left_, panels_[0], panels_[1]}) widget->setFixedWidth(left_width);
    for (QWidget* widget : {right_, panels_[2]}) widget->setFixedWidth(right_width);
    right_->show();
}

}  // namespace psicarve::ui
