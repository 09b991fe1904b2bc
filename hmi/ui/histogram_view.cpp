// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/histogram_view.hpp"

#include <QVBoxLayout>

#include <algorithm>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/plot.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {
namespace {

constexpr double kBarWidth = 0.72;   // of the distance from bar to bar
constexpr double kLeastCount = 0.5;  // where the logarithmic axis begins: a single tick is to be seen
constexpr double kRoomAbove = 6.0;   // times the greatest count, for the words there
constexpr double kLabelWidth_px = 70.0;

QFont small_font(const QWidget& widget) {
    QFont font = widget.font();
    font.setPixelSize(kSmallText_px);
    return font;
}

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot) {
    setMinimumSize(300, 160);
    setAccessibleName(tr("How late ticks were: number of ticks by lateness"));
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(plot_);
    plot_->setFocusPolicy(Qt::NoFocus);
    in_time_ = new QCPBars{plot_->xAxis, plot_->yAxis};
    too_late_ = new QCPBars{plot_->xAxis, plot_->yAxis};
    for (QCPBars* bars : {in_time_, too_late_}) {
        bars->setWidth(kBarWidth);
        bars->setBaseValue(kLeastCount);
    }
    plot_->yAxis->setScaleType(QCPAxis::stLogarithmic);
    plot_->yAxis->setTicker(QSharedPointer<QCPAxisTickerLog>{new QCPAxisTickerLog});
    plot_->yAxis->setNumberFormat("eb");
    plot_->yAxis->setNumberPrecision(0);
    plot_->yAxis->setLabel(tr("Ticks by how late they were (logarithmic)"));
    plot_->xAxis->setSubTicks(false);
    plot_->xAxis->grid()->setVisible(false);
    period_ = new QCPItemStraightLine{plot_};
    period_text_ = text_item();
    period_text_->setText(tr("from here on a tick may have been missed"));
    period_text_->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    nothing_ = text_item();
    nothing_->setText(tr("No tick by a real clock so far"));
    nothing_->position->setType(QCPItemPosition::ptAxisRectRatio);
    nothing_->position->setCoords(0.5, 0.5);
    draw();
}

QCPItemText* HistogramView::text_item() {
    auto* item = new QCPItemText{plot_};
    item->setFont(small_font(*this));
    return item;
}

void HistogramView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    colour();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void HistogramView::show_health(const session::TickHealth& health) {
    if (health.ticks == health_.ticks && health.missed == health_.missed) return;
    health_ = health;
    draw();
}

void HistogramView::colour() {
    plot_->setBackground(tokens_->view);
    for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setBasePen(tokens_->edge);
        axis->setTickPen(tokens_->edge);
        axis->setSubTickPen(tokens_->edge);
        axis->setTickLabelColor(tokens_->text2);
        axis->setLabelColor(tokens_->text2);
        axis->setTickLabelFont(small_font(*this));
        axis->setLabelFont(small_font(*this));
        axis->grid()->setPen(tokens_->line);
    }
    const auto fill = [](QCPBars* bars, const QColor& colour) {
        bars->setPen(Qt::NoPen);
        bars->setBrush(colour);
    };
    fill(in_time_, tokens_->run_fill);
    fill(too_late_, tokens_->alarm_fill);
    period_->setPen(QPen{tokens_->warn, 1, Qt::DashLine});
    period_text_->setColor(tokens_->warn);
    nothing_->setColor(tokens_->text2);
    for (QCPItemText* count : counts_) count->setColor(tokens_->text2);
}

void HistogramView::draw() {
    const bool has_ticks = health_.ticks > 0;
    nothing_->setVisible(!has_ticks);
    for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->setVisible(has_ticks);
    for (QCPItemText* count : counts_) plot_->removeItem(count);
    counts_.clear();
    // The first bars, as long as they are empty, say nothing.
    std::size_t first = 0;
    while (first + 1 < health_.bars.size() && health_.bars[first].ticks == 0) ++first;
    draw_bars(first);
    draw_period(first);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void HistogramView::draw_bars(std::size_t first) {
    const std::size_t count = health_.bars.size() - std::min(first, health_.bars.size());
    QVector<double> places[2];
    QVector<double> heights[2];
    QSharedPointer<QCPAxisTickerText> names{new QCPAxisTickerText};
    // Every second name, or fewer, where there are many.
    const double step_px = std::max(1.0, static_cast<double>(width())) / static_cast<double>(count + 1);
    const std::size_t every = static_cast<std::size_t>(kLabelWidth_px / step_px) + 1;
    double greatest = 1.0;
    for (std::size_t i = 0; i < count; ++i) {
        const session::LatenessBar& bar = health_.bars[first + i];
        const auto place = static_cast<double>(i);
        const auto ticks = static_cast<double>(bar.ticks);
        const int kind = first + i >= health_.period_bar ? 1 : 0;
        places[kind].append(place);
        heights[kind].append(std::max(ticks - kLeastCount, 0.0));  // above the base
        greatest = std::max(greatest, ticks);
        if (i % every == 0) names->addTick(place, QString::fromStdString(bar.label));
        if (bar.ticks == 0) continue;
        QCPItemText* text = text_item();
        text->setText(QString::fromStdString(session::count_text(static_cast<std::int64_t>(bar.ticks))));
        text->position->setCoords(place, ticks);
        text->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
        if (tokens_ != nullptr) text->setColor(kind == 1 ? tokens_->alarm : tokens_->text2);
        counts_.push_back(text);
    }
    in_time_->setData(places[0], heights[0], true);
    too_late_->setData(places[1], heights[1], true);
    plot_->xAxis->setTicker(names);
    plot_->xAxis->setRange(-1.0, static_cast<double>(count));
    plot_->yAxis->setRange(kLeastCount, greatest * kRoomAbove);
}

void HistogramView::draw_period(std::size_t first) {
    const bool is_shown =
        health_.ticks > 0 && health_.period_bar >= first && health_.period_bar < health_.bars.size();
    period_->setVisible(is_shown);
    period_text_->setVisible(is_shown);
    if (!is_shown) return;
    const double place = static_cast<double>(health_.period_bar - first) - 0.5;
    period_->point1->setCoords(place, 1.0);
    period_->point2->setCoords(place, 2.0);
    const bool is_right = 2.0 * place > static_cast<double>(health_.bars.size() - first);
    period_text_->setPositionAlignment(Qt::AlignTop | (is_right ? Qt::AlignRight : Qt::AlignLeft));
    period_text_->position->setCoords(is_right ? place - 0.05 : place + 0.05, 0.01);
}

}  // namespace psicarve::ui
