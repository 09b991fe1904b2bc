// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/side_panels.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "hmi/session/preflight.hpp"
#include "hmi/ui/floating_panel.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/order_card.hpp"
#include "hmi/ui/preflight_list.hpp"

namespace psicarve::ui {
namespace {

// Less would lay the panels' parts on top of each other.
constexpr QSize kLeastForUsual{1100, 690};
constexpr QSize kLeastForWide{1600, 880};
constexpr QSize kUsualSize{1280, 720};
constexpr QSize kFrameOfWindow{8, 40};  // a title bar, and what is round the rest
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
    const bool is_wide = window.width() >= kLeastForWide.width() && window.height() >= kLeastForWide.height();
    return is_wide ? Room::wide : Room::usual;
}

FirstPlace first_place(QSize screen) {
    const QSize size = kUsualSize.boundedTo(screen - kFrameOfWindow);
    return {size, room_in(size) == Room::small && room_in(screen) != Room::small};
}

MotionBlock::MotionBlock(WindowContext& context)
    : context_(context),
      buttons_(make_motion_buttons(context)),
      reason_(role_label("label")),
      refused_(new OrderCard{context, session::OrderPlace::job, "motion", OrderCard::Shape::high, this}) {
    setObjectName("motion");
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kSmallGap);
    buttons_.start->setObjectName("motion_start");
    buttons_.hold->setObjectName("motion_hold");
    buttons_.resume->setObjectName("motion_resume");
    buttons_.stop->setObjectName("motion_stop");
    // It may say "Continue from layer 1320".
    grid->addWidget(buttons_.start, 0, 0, 1, 3);
    int place = 0;
    for (ActionButton* button : {buttons_.hold, buttons_.resume, buttons_.stop}) {
        grid->addWidget(button, 1, place);
        grid->setColumnStretch(place, 1);
        ++place;
    }
    reason_->setObjectName("motion_reason");
    reason_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid->addWidget(reason_, 2, 0, 1, place);
}

void MotionBlock::set_theme(const Tokens& tokens) {
    buttons_.start->set_glyph(Glyph::play, tokens);
    buttons_.hold->set_glyph(Glyph::pause, tokens);
    buttons_.stop->set_glyph(Glyph::stop, tokens);
    refused_->set_theme(tokens);
}

void MotionBlock::refresh() {
    show_what_starts(*buttons_.start, context_);
    for (ActionButton* button : buttons_.all()) button->refresh(context_);
    // Start is locked in a recording.
    const QString to_look_at =
        buttons_.start->isEnabled() && isVisible()
            ? to_look_at_in(session::preflight_checks(context_.machine.view(), context_.open_job.view()))
            : QString{};
    const QString reason = said_beside(buttons_, to_look_at);
    // Where there is room for it Start stands in the Job panel, which has one of its own.
    if (isHidden())
        refused_->hide();
    else
        refused_->refresh_beside(*this, *buttons_.start);
    set_plain_tip(*reason_, reason);
    const QString shown = reason_->fontMetrics().elidedText(reason, Qt::ElideRight, reason_->width());
    if (reason_->text() != shown) reason_->setText(shown);
}

SidePanels::SidePanels(WindowContext& context, QWidget* position, QWidget* jog, QWidget* job)
    : panels_{position, jog, job},
      left_(new QWidget),
      right_(new QWidget),
      left_column_(column_in(left_)),
      right_column_(column_in(right_)),
      names_(new QTabBar{left_}),
      stack_(new QStackedWidget{left_}),
      buttons_(new MotionBlock{context}) {
    names_->setObjectName("side_names");
    names_->setDrawBase(false);
    stack_->setObjectName("side_pages");
    buttons_->setParent(left_);
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        pages_[i] = new QScrollArea;
        pages_[i]->setWidgetResizable(true);
        pages_[i]->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        names_->addTab(short_name(i));
        stack_->addWidget(pages_[i]);
    }
    QObject::connect(names_, &QTabBar::currentChanged, stack_, &QStackedWidget::setCurrentIndex);
    spread(Room::usual);
}

SidePanels::~SidePanels() {
    // A frame takes its panel down with it.
    for (auto& frame : floats_) frame.reset();
}

QString SidePanels::name(std::size_t panel) {
    const QString names[kCount] = {tr("Position"), tr("Jog"), tr("Job")};
    return names[panel];
}

/// For a tab; the panel below says its name in full.
QString SidePanels::short_name(std::size_t panel) {
    const QString names[kCount] = {tr("Position"), tr("Jogging"), tr("Job")};
    return names[panel];
}

bool SidePanels::arrange(Room room) {
    if (room == room_) return false;
    room_ = room;
    place();
    return true;
}

void SidePanels::place() {
    if (room_ == Room::small) {
        stack();
    } else {
        spread(room_);
    }
}

void SidePanels::float_panel(std::size_t panel, QWidget* window, std::function<void()> put_back,
                             std::function<void()> left) {
    if (is_floating(panel)) return;
    pages_[panel]->takeWidget();
    floats_[panel] = std::make_unique<FloatingPanel>(*panels_[panel], name(panel), window,
                                                     std::move(put_back), std::move(left));
    floats_[panel]->show();
    place();
}

void SidePanels::dock_panel(std::size_t panel) {
    if (!is_floating(panel)) return;
    panels_[panel]->setParent(left_);
    floats_[panel].reset();
    place();
}

bool SidePanels::is_ours(const QWidget* window) const noexcept {
    return window != nullptr && std::any_of(floats_.begin(), floats_.end(),
                                            [window](const auto& frame) { return frame.get() == window; });
}

QWidget& SidePanels::frame(std::size_t panel) noexcept {
    return *floats_[panel];
}

void SidePanels::stack() {
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        panels_[i]->setMinimumWidth(0);
        panels_[i]->setMaximumWidth(QWIDGETSIZE_MAX);
        names_->setTabVisible(static_cast<int>(i), !is_floating(i));
        if (is_floating(i)) continue;
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
    left_->show();
    right_->hide();
}

void SidePanels::spread(Room room) {
    const bool is_wide = room == Room::wide;
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        pages_[i]->takeWidget();
        if (is_floating(i)) continue;
        if (i == 2) right_column_->addWidget(panels_[i], 1);
        if (i == 1) left_column_->addWidget(panels_[i], 1);
        if (i == 0)
            left_column_->insertWidget(0, panels_[i], 0, is_floating(1) ? Qt::AlignTop : Qt::Alignment{});
        panels_[i]->show();
    }
    for (QWidget* widget :
         {static_cast<QWidget*>(names_), static_cast<QWidget*>(stack_), static_cast<QWidget*>(buttons_)}) {
        left_column_->removeWidget(widget);
        widget->hide();
    }
    const int left_width = is_wide ? kWideLeftWidth : kLeftWidth;
    const int right_width = is_wide ? kWideRightWidth : kRightWidth;
    for (QWidget* widget : {left_, panels_[0], panels_[1]}) widget->setFixedWidth(left_width);
    for (QWidget* widget : {right_, panels_[2]}) widget->setFixedWidth(right_width);
    left_->setVisible(!is_floating(0) || !is_floating(1));
    right_->setVisible(!is_floating(2));
}

}  // namespace psicarve::ui
