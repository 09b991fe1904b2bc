// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/timing_view.hpp"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <chrono>
#include <utility>

#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {
namespace {

using session::LevelHistory;

constexpr int kMark_s = 5;
constexpr double kHighShare = 0.22;  // of a row's height, from its top
constexpr double kLowShare = 0.78;
// The least height of a band of steps: one step in a look is to be seen.
constexpr double kLeastBandShare = 0.12;

}  // namespace

TimingView::TimingView(QWidget* parent) : QWidget(parent) {
    setMinimumWidth(160);
    setAccessibleName(
        QCoreApplication::translate("psicarve::ui::TimingView", "Levels of all pins in the last 20 seconds"));
}

void TimingView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    update();
}

void TimingView::set_rows(std::vector<Signal> signals_of_rows, int first_row_px, int row_height_px) {
    rows_ = std::move(signals_of_rows);
    first_row_px_ = first_row_px;
    row_height_px_ = row_height_px;
    update();
}

void TimingView::show_history(const LevelHistory& history, LevelHistory::Clock::time_point now) {
    history_ = &history;
    now_ = now;
    update();
}

double TimingView::x_of(LevelHistory::Clock::time_point time) const {
    const double share =
        std::chrono::duration<double>(now_ - time) / std::chrono::duration<double>(LevelHistory::kLength);
    return std::clamp(1.0 - share, 0.0, 1.0) * width();
}

QColor TimingView::colour_of(Signal signal) const {
    for (const Signal of_r1 : {Signal::r1_step, Signal::r1_dir, Signal::r1_enable, Signal::r1_limit}) {
        if (signal == of_r1) return tokens_->r1;
    }
    for (const Signal of_r2 : {Signal::r2_step, Signal::r2_dir, Signal::r2_enable, Signal::r2_limit}) {
        if (signal == of_r2) return tokens_->r2;
    }
    return tokens_->text;
}

void TimingView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    painter.fillRect(rect(), tokens_->view);
    QFont small = font();
    small.setPixelSize(kSmallText_px);
    painter.setFont(small);
    const int seconds = static_cast<int>(LevelHistory::kLength.count());
    for (int ago = kMark_s; ago < seconds; ago += kMark_s) {
        const int x = static_cast<int>(width() * (1.0 - static_cast<double>(ago) / seconds));
        painter.setPen(tokens_->line);
        painter.drawLine(x, first_row_px_, x, height());
        painter.setPen(tokens_->text2);
        painter.drawText(QRect{x - 30, 0, 60, first_row_px_}, Qt::AlignCenter,
                         QStringLiteral("\u2212%1 s").arg(ago));
    }
    if (history_ == nullptr || history_->looks().empty()) return;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const QRectF row{0.0, static_cast<double>(first_row_px_) + static_cast<double>(i) * row_height_px_,
                         static_cast<double>(width()), static_cast<double>(row_height_px_)};
        const auto number = index_of(rows_[i]);
        if (number < kAxisCount) {
            draw_steps(painter, static_cast<Axis>(number), row);
        } else {
            draw_levels(painter, rows_[i], row);
        }
    }
}

void TimingView::draw_levels(QPainter& painter, Signal signal, const QRectF& row) const {
    const auto y_of = [&](SignalWord levels) {
        return row.top() + row.height() * ((levels & bit_of(signal)) != 0 ? kHighShare : kLowShare);
    };
    const auto& looks = history_->looks();
    QPainterPath line;
    double y = y_of(looks.front().levels);
    line.moveTo(x_of(looks.front().time), y);
    for (const LevelHistory::Look& look : looks) {
        const double next = y_of(look.levels);
        if (next == y) continue;
        const double x = x_of(look.time);
        line.lineTo(x, y);
        line.lineTo(x, next);
        y = next;
    }
    line.lineTo(x_of(looks.back().time), y);
    painter.setPen(QPen{colour_of(signal), 1.2});
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(line);
}

void TimingView::draw_steps(QPainter& painter, Axis axis, const QRectF& row) const {
    const auto& looks = history_->looks();
    const double low = row.top() + row.height() * kLowShare;
    const double room = row.height() * (kLowShare - kHighShare);
    const std::size_t k = index_of(axis);
    double most = 0.0;
    const auto rate_of = [&](std::size_t i) {
        const double seconds = std::chrono::duration<double>(looks[i].time - looks[i - 1].time).count();
        return seconds > 0.0 ? static_cast<double>(looks[i].pulses[k]) / seconds : 0.0;
    };
    for (std::size_t i = 1; i < looks.size(); ++i) most = std::max(most, rate_of(i));
    const QColor colour = colour_of(step_of(axis));
    for (std::size_t i = 1; i < looks.size() && most > 0.0; ++i) {
        if (looks[i].pulses[k] == 0) continue;
        const double height = room * std::max(kLeastBandShare, rate_of(i) / most);
        const double begin = x_of(looks[i - 1].time);
        painter.fillRect(QRectF{begin, low - height, std::max(1.0, x_of(looks[i].time) - begin), height},
                         colour);
    }
    painter.setPen(QPen{colour, 1.2});
    painter.drawLine(QPointF{x_of(looks.front().time), low}, QPointF{x_of(looks.back().time), low});
}

}  // namespace psicarve::ui
