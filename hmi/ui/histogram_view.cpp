// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/histogram_view.hpp"

#include <QPainter>

#include <algorithm>

#include "hmi/session/display_text.hpp"

namespace psicarve::ui {
namespace {

constexpr int kMargin_px = 16;
constexpr int kLabelHeight_px = 34;
constexpr int kCountHeight_px = 18;
constexpr int kText_px = 11;
constexpr double kBarShare = 0.72;

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(300, 160);
    setAccessibleName(tr("How late ticks were: number of ticks by lateness"));
}

void HistogramView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    update();
}

void HistogramView::show_health(const session::TickHealth& health) {
    if (health.ticks == health_.ticks && health.missed == health_.missed) return;
    health_ = health;
    update();
}

void HistogramView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    painter.fillRect(rect(), tokens_->view);
    QFont small = font();
    small.setPixelSize(kText_px);
    painter.setFont(small);
    painter.setPen(tokens_->text2);
    if (health_.ticks == 0) {
        painter.drawText(rect(), Qt::AlignCenter, tr("No tick by a real clock so far"));
        return;
    }
    // The first bars that nobody was in say nothing.
    std::size_t first = 0;
    while (first + 1 < health_.bars.size() && health_.bars[first].ticks == 0) ++first;
    const auto count = static_cast<int>(health_.bars.size() - first);
    const QRect area =
        rect().adjusted(kMargin_px, kMargin_px + kCountHeight_px, -kMargin_px, -kLabelHeight_px);
    const double step = static_cast<double>(area.width()) / count;
    painter.drawText(QRect{area.left(), 2, area.width(), kMargin_px + 2}, Qt::AlignLeft | Qt::AlignVCenter,
                     tr("Ticks by how late they were (logarithmic)"));
    for (int i = 0; i < count; ++i) {
        const std::size_t bin = first + static_cast<std::size_t>(i);
        const session::LatenessBar& bar = health_.bars[bin];
        const bool is_too_late = bin >= health_.period_bar;
        const double left = area.left() + i * step;
        const double height = bar.height * area.height();
        const QRectF box{left + step * (1.0 - kBarShare) / 2.0, area.bottom() - height, step * kBarShare,
                         height};
        painter.fillRect(box, is_too_late ? tokens_->alarm_fill : tokens_->run_fill);
        painter.setPen(is_too_late && bar.ticks > 0 ? tokens_->alarm : tokens_->text2);
        if (bar.ticks > 0) {
            const QRectF above{left, box.top() - kCountHeight_px, step, static_cast<double>(kCountHeight_px)};
            painter.drawText(
                above, Qt::AlignCenter,
                QString::fromStdString(session::count_text(static_cast<std::int64_t>(bar.ticks))));
        }
        painter.setPen(tokens_->text2);
        // Labels lie askew no more than they have room: every second one where they are many.
        constexpr double kLabelWidth_px = 62.0;
        const int every = std::max(1, static_cast<int>(kLabelWidth_px / step) + 1);
        if (i % every != 0) continue;
        const QRectF below{left - kLabelWidth_px / 2.0 + step / 2.0, area.bottom() + 4.0, kLabelWidth_px,
                           16.0};
        painter.drawText(below, Qt::AlignCenter, QString::fromStdString(bar.label));
    }
    painter.setPen(tokens_->edge);
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    if (health_.period_bar >= first && health_.period_bar < health_.bars.size()) {
        const int x = area.left() + static_cast<int>(static_cast<double>(health_.period_bar - first) * step);
        painter.setPen(QPen{tokens_->warn, 1, Qt::DashLine});
        painter.drawLine(x, area.top() - kCountHeight_px, x, area.bottom());
        painter.setPen(tokens_->warn);
        painter.drawText(QRect{x - 204, area.bottom() + 18, 400, 14}, Qt::AlignCenter,
                         tr("from here on a tick may have been missed"));
    }
}

}  // namespace psicarve::ui
