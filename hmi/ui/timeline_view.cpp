// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/timeline_view.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/words.hpp"
#include "shared/base/units.hpp"

namespace psicarve::ui {
namespace {

constexpr int kTimelineViewHeight = 78;
constexpr int kSide = 8;
constexpr int kLabels = 16;  // height of the marks' words
constexpr int kAxis = 16;
constexpr int kNear_px = 5;
constexpr int kMostWords = 6;
constexpr std::int64_t kStep_ns = kNsPerS;
constexpr std::int64_t kFineStep_ns = kNsPerS / 100;
constexpr int kLeastBetweenTicks_px = 90;

/// 1, 2 or 5 times a power of ten, or minutes: so that labels do not touch.
std::int64_t tick_step_ns(std::int64_t least_ns) {
    for (std::int64_t step = 1'000'000; step < 60 * kNsPerS; step *= 10) {
        for (const std::int64_t of_it : {1, 2, 5}) {
            if (step * of_it >= least_ns) return step * of_it;
        }
    }
    for (const std::int64_t minutes : {1, 2, 5, 10, 20, 30, 60, 120, 300, 600}) {
        if (minutes * 60 * kNsPerS >= least_ns) return minutes * 60 * kNsPerS;
    }
    return std::max<std::int64_t>(least_ns, 1);
}

QString tick_text(std::int64_t time_ns, std::int64_t step_ns) {
    const std::string text =
        step_ns >= kNsPerS ? session::clock_text(seconds_from_ns(time_ns)) : session::time_text_ms(time_ns);
    return QString::fromStdString(text);
}

}  // namespace

TimelineView::TimelineView(replay::ReplaySession& replay, QWidget* parent)
    : QWidget(parent), replay_(replay) {
    setObjectName("timeline");
    setFixedHeight(kTimelineViewHeight);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Timeline of the recording"));
}

void TimelineView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    update();
}

void TimelineView::refresh() {
    if (drawn_ns_ == replay_.clock().now_ns() && drawn_edition_ == replay_.edition()) return;
    drawn_ns_ = replay_.clock().now_ns();
    drawn_edition_ = replay_.edition();
    setAccessibleDescription(QString::fromStdString(session::time_text_ms(drawn_ns_)));
    update();
}

int TimelineView::x_of(std::int64_t time_ns) const {
    const std::int64_t end_ns = std::max<std::int64_t>(replay_.clock().end_ns(), 1);
    const double share = static_cast<double>(time_ns) / static_cast<double>(end_ns);
    return kSide + qRound(share * (width() - 2 * kSide));
}

std::int64_t TimelineView::time_of(int x) const {
    const double share =
        std::clamp(static_cast<double>(x - kSide) / std::max(width() - 2 * kSide, 1), 0.0, 1.0);
    return std::llround(share * static_cast<double>(replay_.clock().end_ns()));
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) replay_.clock().seek(time_of(event->pos().x()));
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0) replay_.clock().seek(time_of(event->pos().x()));
}

void TimelineView::keyPressEvent(QKeyEvent* event) {
    replay::ReplayClock& clock = replay_.clock();
    const bool is_fine = (event->modifiers() & Qt::ShiftModifier) != 0;
    const std::int64_t step_ns = is_fine ? kFineStep_ns : kStep_ns;
    switch (event->key()) {
        case Qt::Key_Left:
            return clock.seek(clock.now_ns() - step_ns);
        case Qt::Key_Right:
            return clock.seek(clock.now_ns() + step_ns);
        case Qt::Key_PageUp:
            return clock.seek(clock.now_ns() - clock.end_ns() / 10);
        case Qt::Key_PageDown:
            return clock.seek(clock.now_ns() + clock.end_ns() / 10);
        case Qt::Key_Home:
            return clock.seek(0);
        case Qt::Key_End:
            return clock.seek(clock.end_ns());
        default:
            QWidget::keyPressEvent(event);
    }
}

QString TimelineView::words_at(int x) const {
    QString text;
    int count = 0;
    const auto& entries = replay_.facts().entries;
    const int first = replay::entry_before(entries, time_of(x - kNear_px));
    for (std::size_t i = static_cast<std::size_t>(first) + 1; i < entries.size(); ++i) {
        if (x_of(entries[i].time_ns) > x + kNear_px) break;
        if (++count > kMostWords) return text + QStringLiteral("\n\u2026");
        if (!text.isEmpty()) text += "\n";
        text +=
            QString::fromStdString(session::time_text_ms(entries[i].time_ns)) + "  " + words(entries[i].what);
    }
    return text;
}

bool TimelineView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString text = words_at(help->pos().x());
    QToolTip::showText(
        help->globalPos(),
        text.isEmpty() ? QString::fromStdString(session::time_text_ms(time_of(help->pos().x()))) : text,
        this);
    return true;
}

void TimelineView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    QFont small = font();
    small.setPixelSize(kSmallText_px);
    painter.setFont(small);
    const QRect track{kSide, kLabels, width() - 2 * kSide, height() - kLabels - kAxis};
    painter.fillRect(track, tokens_->view);
    QColor played = tokens_->sim_fill;
    played.setAlpha(70);
    painter.fillRect(QRect{track.topLeft(), QPoint{x_of(replay_.clock().now_ns()), track.bottom()}}, played);
    paint_activity(painter);
    paint_axis(painter);
    paint_marks(painter);
    paint_cursor(painter);
    if (hasFocus()) {
        painter.setPen(QPen{tokens_->text, 2});
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(track.adjusted(-2, -2, 2, 2));
    }
}

void TimelineView::paint_axis(QPainter& painter) const {
    const std::int64_t end_ns = replay_.clock().end_ns();
    const int bottom = height() - kAxis;
    painter.setPen(tokens_->line);
    painter.drawLine(kSide, bottom, width() - kSide, bottom);
    if (end_ns <= 0) return;
    const double ns_per_px = static_cast<double>(end_ns) / std::max(width() - 2 * kSide, 1);
    const std::int64_t step_ns = tick_step_ns(std::llround(ns_per_px * kLeastBetweenTicks_px));
    for (std::int64_t time_ns = 0; time_ns <= end_ns; time_ns += step_ns) {
        const int x = x_of(time_ns);
        painter.setPen(tokens_->line);
        painter.drawLine(x, bottom, x, bottom + 3);
        painter.setPen(tokens_->text2);
        const QRect place{x + 3, bottom + 1, kLeastBetweenTicks_px, kAxis - 1};
        if (place.left() + 40 < width()) painter.drawText(place, Qt::AlignLeft, tick_text(time_ns, step_ns));
    }
}

void TimelineView::paint_activity(QPainter& painter) const {
    const auto& activity = replay_.facts().activity;
    if (activity.empty()) return;
    const double low = height() - kAxis - 4;
    const double room = height() - kAxis - kLabels - 12;
    const double part = static_cast<double>(width() - 2 * kSide) / static_cast<double>(activity.size());
    QPainterPath line;
    for (std::size_t i = 0; i < activity.size(); ++i) {
        const QPointF place{kSide + part * (static_cast<double>(i) + 0.5),
                            low - room * static_cast<double>(activity[i])};
        if (i == 0) line.moveTo(place);
        line.lineTo(place);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen{tokens_->text2, 1.2});
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(line);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void TimelineView::paint_marks(QPainter& painter) const {
    const int bottom = height() - kAxis;
    int free_from = 0;    // words do not run into each other
    int last_mark = -10;  // nor lines
    for (const replay::Entry& entry : replay_.facts().entries) {
        const bool is_plain = entry.severity == session::Severity::info;
        if (!entry.is_major) continue;
        const int x = x_of(entry.time_ns);
        if (x == last_mark && is_plain) continue;
        last_mark = x;
        const QColor colour = is_plain                                       ? tokens_->text2
                              : entry.severity == session::Severity::warning ? tokens_->warn
                                                                             : tokens_->alarm;
        painter.setPen(QPen{colour, is_plain ? 1.0 : 2.0});
        painter.drawLine(x, kLabels, x, bottom);
        const QString text = words(entry.what);
        const int wide = painter.fontMetrics().horizontalAdvance(text);
        const int left = x + 3 + wide > width() ? x - 3 - wide : x + 3;
        if (left < free_from) continue;
        free_from = left + wide + 8;
        painter.drawText(QRect{left, 0, wide + 2, kLabels}, Qt::AlignLeft | Qt::AlignVCenter, text);
    }
}

void TimelineView::paint_cursor(QPainter& painter) const {
    constexpr int kHalf = 6;
    const int x = x_of(replay_.clock().now_ns());
    painter.setPen(QPen{tokens_->text, 2});
    painter.drawLine(x, kLabels, x, height() - kAxis + 2);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tokens_->text);
    painter.drawPolygon(QPolygon{{{x - kHalf, kLabels - 6}, {x + kHalf, kLabels - 6}, {x, kLabels + 4}}});
}

}  // namespace psicarve::ui
