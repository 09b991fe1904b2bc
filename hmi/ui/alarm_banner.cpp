// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/alarm_banner.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

#include "hmi/session/lost_core.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/last_known.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kIconWidth = 48;
constexpr int kIconSide = 28;
constexpr int kNarrowIconWidth = 36;
constexpr int kButtonWidth = 140;
constexpr int kLeastForBoth = 480;     // text, and buttons beside it
constexpr int kLeastTextHeight = 100;  // the title, and what to do or some of why

/// "Continue from layer 52" is not torn at the end of a line.
QString whole_if_short(QString step) {
    constexpr qsizetype kShort = 24;
    return step.size() > kShort ? step : step.replace(' ', QChar::Nbsp);
}

}  // namespace

AlarmBanner::AlarmBanner(WindowContext& context, QWidget* parent)
    : QFrame(parent),
      context_(context),
      icon_(new QLabel),
      title_(role_label("title")),
      detail_(plain_label()),
      steps_(new QLabel),
      back_off_(new ActionButton{session::Action::back_off, tr("Back off"), [this] { back_off(); }}),
      reset_(new ActionButton{
          session::Action::reset_alarm, tr("Reset alarm"),
          [this] { context_.machine.order(CommandKind::reset_alarm, session::phrase("Reset alarm")); }}),
      acknowledge_(new QPushButton{tr("Acknowledge")}),
      reason_(role_label("label")),
      room_(new QScrollArea) {
    setObjectName("banner");
    icon_->setAlignment(Qt::AlignCenter);
    title_->setObjectName("alarm_title");
    back_off_->setObjectName("back_off");
    back_off_->set_hint(tr("Moves the axis away from its closed switch, slowly"));
    reset_->setObjectName("reset_alarm");
    acknowledge_->setObjectName("acknowledge");
    acknowledge_->setFocusPolicy(Qt::TabFocus);
    acknowledge_->setToolTip(tr("Takes this away once it was read; it moves and stops nothing"));
    connect(acknowledge_, &QPushButton::clicked, this, [this] {
        context_.machine.acknowledge_unheard_stop();
        refresh();
    });
    detail_->setObjectName("alarm_detail");
    steps_->setObjectName("alarm_steps");
    reason_->setObjectName("alarm_reason");
    for (QLabel* label : {title_, detail_, steps_, reason_}) label->setWordWrap(true);
    make_text();
    make_keys();
    auto* said = new QHBoxLayout;
    said->setSpacing(0);
    said->addWidget(icon_);
    said->addWidget(room_, 1);
    parts_ = new QBoxLayout{QBoxLayout::LeftToRight, this};
    parts_->setContentsMargins(0, 0, 0, 0);
    parts_->setSpacing(0);
    parts_->addLayout(said, 1);
    parts_->addLayout(keys_);
    arrange(false);
    setVisible(false);
}

void AlarmBanner::make_text() {
    auto* inside = new QWidget;
    text_ = new QVBoxLayout{inside};
    text_->setContentsMargins(0, kGap, kGap, kGap);
    text_->setSpacing(1);
    for (QLabel* label : {title_, detail_, steps_}) text_->addWidget(label);
    text_->addStretch();
    room_->setObjectName("alarm_room");
    room_->setWidgetResizable(true);
    room_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    room_->setFrameShape(QFrame::NoFrame);
    room_->setFocusPolicy(Qt::NoFocus);
    room_->setMinimumHeight(0);
    room_->setWidget(inside);
}

void AlarmBanner::make_keys() {
    keys_ = new QBoxLayout{QBoxLayout::TopToBottom};
    keys_->setSpacing(kSmallGap);
    for (QWidget* key : {static_cast<QWidget*>(back_off_), static_cast<QWidget*>(reset_),
                         static_cast<QWidget*>(acknowledge_), static_cast<QWidget*>(reason_)})
        keys_->addWidget(key);
    keys_->addStretch();
}

void AlarmBanner::arrange(bool is_narrow) {
    is_narrow_ = is_narrow;
    parts_->setDirection(is_narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    keys_->setDirection(is_narrow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    keys_->setContentsMargins(is_narrow ? kGap : 0, is_narrow ? 0 : kGap, kGap, kGap);
    for (QWidget* key : {static_cast<QWidget*>(back_off_), static_cast<QWidget*>(reset_),
                         static_cast<QWidget*>(acknowledge_), static_cast<QWidget*>(reason_)}) {
        key->setMinimumWidth(is_narrow ? 0 : kButtonWidth);
        key->setMaximumWidth(is_narrow ? QWIDGETSIZE_MAX : kButtonWidth);
    }
    // Beside its buttons the reason would be a word wide.
    text_->removeWidget(reason_);
    keys_->removeWidget(reason_);
    QBoxLayout& place = is_narrow ? static_cast<QBoxLayout&>(*text_) : *keys_;
    place.insertWidget(3, reason_);
    icon_->setFixedWidth(is_narrow ? kNarrowIconWidth : kIconWidth);
}

void AlarmBanner::resizeEvent(QResizeEvent* event) {
    const bool is_narrow = event->size().width() < kLeastForBoth;
    if (is_narrow != is_narrow_) arrange(is_narrow);
    refresh_height();
    QFrame::resizeEvent(event);
}

int AlarmBanner::keys_height() const {
    return keys_->hasHeightForWidth() ? keys_->heightForWidth(keys_->sizeHint().width())
                                      : keys_->sizeHint().height();
}

int AlarmBanner::full_height() const {
    const int beside = icon_->width() + (is_narrow_ ? 0 : keys_->sizeHint().width());
    const int text = text_->heightForWidth(std::max(1, contentsRect().width() - beside));
    return frame_height() + (is_narrow_ ? text + keys_height() : std::max(text, keys_height()));
}

void AlarmBanner::refresh_height() {
    const int needed = full_height();
    if (needed == full_height_) return;
    full_height_ = needed;
    updateGeometry();
}

QSize AlarmBanner::sizeHint() const {
    return {QFrame::sizeHint().width(), full_height_};
}

QSize AlarmBanner::minimumSizeHint() const {
    const int least = frame_height() + keys_height() + (is_narrow_ ? kLeastTextHeight : 0);
    return {QFrame::minimumSizeHint().width(), std::min(least, full_height_)};
}

void AlarmBanner::set_theme(const Tokens& tokens) {
    icon_->setPixmap(glyph_pixmap(Glyph::octagon, kIconSide, tokens.alarm));
    refresh();
}

void AlarmBanner::back_off() {
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
        if (!context_.machine.view().is_active(sensor_of(axis))) continue;
        Command command{};
        command.kind = CommandKind::back_off;
        command.axis = static_cast<std::uint32_t>(index_of(axis));
        context_.machine.order(command, session::phrase("Back off"));
        return;
    }
}

/// Without a core there is nothing to be reset.
void AlarmBanner::refresh_buttons() {
    const session::MachineView& view = context_.machine.view();
    QStringList reasons;
    for (ActionButton* button : {back_off_, reset_}) {
        const QString& reason = button->refresh(context_);
        if (!reason.isEmpty() && !reasons.contains(reason)) reasons << reason;
    }
    const auto& refused = context_.machine.refused_order();
    const bool is_refused = refused && refused->place == session::OrderPlace::alarm;
    reason_->setText(is_refused ? words(refused->what) : reasons.join('\n'));
    set_styled(reason_, "trouble", is_refused ? "yes" : "no");
    const bool has_core = view.is_heard();
    for (QWidget* widget :
         {static_cast<QWidget*>(back_off_), static_cast<QWidget*>(reset_), static_cast<QWidget*>(reason_)}) {
        if (widget->isHidden() == has_core) widget->setVisible(has_core);
    }
    if (acknowledge_->isHidden() == view.unheard_stop) acknowledge_->setVisible(view.unheard_stop);
}

void AlarmBanner::refresh() {
    const session::MachineView& view = context_.machine.view();
    const auto text = session::loud_text(view);
    refresh_buttons();
    const bool was_hidden = isHidden();
    if (was_hidden == text.has_value()) setVisible(text.has_value());
    if (!text) return;
    const QString title = words(text->title);
    if (was_hidden || title_->text() != title) room_->verticalScrollBar()->setValue(0);
    title_->setText(title);
    const bool is_past = !view.is_heard() && view.status;
    detail_->setText(is_past ? QStringLiteral("%1 (%2)").arg(words(text->detail), last_known(view))
                             : words(text->detail));
    detail_->setToolTip(detail_->text());  // a very low window has no room for all of it
    QString steps;
    for (std::size_t i = 0; i < text->steps.size(); ++i) {
        steps += QString{"%1<b>%2</b>&nbsp;%3"}
                     .arg(i == 0 ? "" : " &nbsp; ")
                     .arg(i + 1)
                     .arg(whole_if_short(words(text->steps[i])).toHtmlEscaped());
    }
    steps_->setText(steps);
    setAccessibleName(tr("Alarm: %1").arg(title_->text()));
    refresh_height();
}

}  // namespace psicarve::ui
