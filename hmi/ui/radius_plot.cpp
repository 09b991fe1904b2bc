// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/radius_plot.hpp"

#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "hmi/ui/plot.hpp"

namespace psicarve::ui {
namespace {

constexpr int kLeastPlotHeight_px = 76;
constexpr double kRadiusLine_px = 1.8;
constexpr double kMarkSide_px = 8.0;
constexpr double kRoomAround = 0.08;  // of the radii's range
constexpr double kLeastRange_mm = 0.2;
constexpr int kAngleTicks = 7;
constexpr double kAngleStep_deg = 30.0;
constexpr const char* kMarkLayer = "mark";

QVector<double> as_vector(const std::vector<double>& values) {
    return {values.begin(), values.end()};
}

/// The radii's range with some room, also where all are one.
std::pair<double, double> range_mm(const session::LayerCurves& curves) {
    const auto [r1_least, r1_most] = std::minmax_element(curves.r1_mm.begin(), curves.r1_mm.end());
    const auto [r2_least, r2_most] = std::minmax_element(curves.r2_mm.begin(), curves.r2_mm.end());
    const double least = std::min(*r1_least, *r2_least);
    const double most = std::max(*r1_most, *r2_most);
    const double room = std::max((most - least) * kRoomAround, kLeastRange_mm / 2.0);
    return {least - room, most + room};
}

}  // namespace

RadiusPlot::RadiusPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot) {
    setMinimumSize(200, kLeastPlotHeight_px);
    setAccessibleName(tr("Radius along the layer, both heads"));
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(plot_);
    plot_->setFocusPolicy(Qt::NoFocus);
    plot_->setMinimumSize(0, 0);
    r1_ = plot_->addGraph();
    r2_ = plot_->addGraph();
    // What moves with the machine is drawn without the curves being drawn again.
    plot_->addLayer(kMarkLayer);
    plot_->layer(kMarkLayer)->setMode(QCPLayer::lmBuffered);
    r1_mark_ = plot_->addGraph();
    r2_mark_ = plot_->addGraph();
    for (QCPGraph* mark : {r1_mark_, r2_mark_}) {
        mark->setLayer(kMarkLayer);
        mark->setLineStyle(QCPGraph::lsNone);
    }
    line_ = new QCPItemStraightLine{plot_};
    line_->setLayer(kMarkLayer);
    const QSharedPointer<QCPAxisTickerFixed> degrees{new QCPAxisTickerFixed};
    degrees->setTickStep(kAngleStep_deg);
    degrees->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    degrees->setTickCount(kAngleTicks);
    plot_->xAxis->setTicker(degrees);
    plot_->xAxis->setSubTicks(false);
    plot_->yAxis->setSubTicks(false);
    plot_->axisRect()->setAutoMargins(QCP::msTop | QCP::msBottom);
    plot_->axisRect()->setMargins({kLeftRoom_px, 0, kRightRoom_px, 0});
    plot_->yAxis->ticker()->setTickCount(4);
}

void RadiusPlot::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    colour();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void RadiusPlot::colour() {
    QFont small = font();
    small.setPixelSize(kSmallText_px);
    plot_->setBackground(tokens_->view);
    for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setBasePen(tokens_->edge);
        axis->setTickPen(tokens_->edge);
        axis->setTickLabelColor(tokens_->text2);
        axis->setTickLabelFont(small);
        axis->grid()->setPen(tokens_->line);
    }
    r1_->setPen(QPen{tokens_->r1, kRadiusLine_px});
    r2_->setPen(QPen{tokens_->r2, kRadiusLine_px, Qt::DashLine});
    r1_mark_->setScatterStyle({QCPScatterStyle::ssDisc, tokens_->r1, tokens_->r1, kMarkSide_px});
    r2_mark_->setScatterStyle({QCPScatterStyle::ssDisc, tokens_->r2, tokens_->r2, kMarkSide_px});
    line_->setPen(QPen{tokens_->text, 1.0});
}

void RadiusPlot::show_layer(const session::LayerCurves& curves) {
    curves_ = curves;
    const QVector<double> psi_deg = as_vector(curves.psi_deg);
    r1_->setData(psi_deg, as_vector(curves.r1_mm), true);
    r2_->setData(psi_deg, as_vector(curves.r2_mm), true);
    const auto [least_mm, most_mm] = range_mm(curves);
    plot_->xAxis->setRange(curves.psi_deg.front(), curves.psi_deg.back());
    plot_->yAxis->setRange(least_mm, most_mm);
    point_ = std::min(point_, curves.psi_deg.size() - 1);
    mark(point_);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void RadiusPlot::mark(std::size_t point) {
    point_ = point;
    const double psi_deg = curves_.psi_deg[point];
    r1_mark_->setData({psi_deg}, {curves_.r1_mm[point]});
    r2_mark_->setData({psi_deg}, {curves_.r2_mm[point]});
    line_->point1->setCoords(psi_deg, 0.0);
    line_->point2->setCoords(psi_deg, 1.0);
    plot_->layer(kMarkLayer)->replot();
}

}  // namespace psicarve::ui
