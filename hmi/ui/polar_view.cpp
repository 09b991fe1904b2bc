// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/polar_view.hpp"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::ui {
namespace {

constexpr double kLabelRoom_px = 30.0;
constexpr int kSpoke_deg = 30;
constexpr double kLine_px = 1.8;
constexpr double kHead_px = 8.0;
constexpr double kMark_px = 4.5;
constexpr int kFill_alpha = 38;
constexpr int kTurn_deg = 360;
constexpr double kNearlyOne = 1.0001;  // the outermost ring may be the circle itself
constexpr double kOpposite_deg = 180.0;

/// 1, 2 or 5 times a power of ten, so that three or four circles fit.
double ring_step_mm(double most_mm) {
    const double rough = most_mm / 3.5;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double times : {1.0, 2.0, 5.0}) {
        if (times * power >= rough) return times * power;
    }
    return 10.0 * power;
}

}  // namespace

PolarView::PolarView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(200, 180);
    setAccessibleName(
        QCoreApplication::translate("psicarve::ui::PolarView", "Section of the layer, seen from above"));
}

void PolarView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    update();
}

void PolarView::show_rim(session::LayerRim rim, double most_mm) {
    rim_ = std::move(rim);
    most_mm_ = most_mm;
    update();
}

void PolarView::mark(std::size_t point) {
    if (point == point_) return;
    point_ = point;
    update();
}

void PolarView::show_heads(std::optional<double> r1_direction_deg) {
    if (r1_direction_deg == r1_direction_deg_) return;
    r1_direction_deg_ = r1_direction_deg;
    update();
}

QPointF PolarView::place(double direction_deg, double radius_mm) const {
    const double reach_px = (std::min(width(), height()) / 2.0 - kLabelRoom_px) * radius_mm / most_mm_;
    const double angle_rad = rad_from_deg(direction_deg);
    return {width() / 2.0 + reach_px * std::cos(angle_rad), height() / 2.0 - reach_px * std::sin(angle_rad)};
}

void PolarView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), tokens_->view);
    draw_grid(painter);
    draw_half(painter, rim_.r1, tokens_->r1, Qt::SolidLine);
    draw_half(painter, rim_.r2, tokens_->r2, Qt::DashLine);
    draw_mark(painter, rim_.r1, tokens_->r1);
    draw_mark(painter, rim_.r2, tokens_->r2);
    if (!r1_direction_deg_) return;
    draw_head(painter, *r1_direction_deg_, tokens_->r1, "R1");
    draw_head(painter, *r1_direction_deg_ + kOpposite_deg, tokens_->r2, "R2");
}

void PolarView::draw_grid(QPainter& painter) const {
    QFont small = font();
    small.setPixelSize(11);
    painter.setFont(small);
    painter.setPen(QPen{tokens_->line, 1.0});
    const QPointF middle = place(0.0, 0.0);
    const double step_mm = ring_step_mm(most_mm_);
    const int rings = static_cast<int>(most_mm_ / step_mm * kNearlyOne);
    for (int ring = 1; ring <= rings; ++ring) {
        const double reach = place(0.0, ring * step_mm).x() - middle.x();
        painter.drawEllipse(middle, reach, reach);
    }
    for (int angle_deg = 0; angle_deg < kTurn_deg; angle_deg += kSpoke_deg) {
        painter.setPen(QPen{tokens_->line, 1.0});
        painter.drawLine(middle, place(angle_deg, most_mm_));
        painter.setPen(tokens_->text2);
        const QPointF at = place(angle_deg, most_mm_ * 1.09);
        painter.drawText(QRectF{at.x() - 20, at.y() - 8, 40, 16}, Qt::AlignCenter,
                         QString{"%1°"}.arg(angle_deg));
    }
    painter.setPen(tokens_->text2);
    for (int ring = 1; ring <= rings; ++ring)
        painter.drawText(place(0.0, ring * step_mm) + QPointF{-16, 13}, QString::number(ring * step_mm));
}

void PolarView::draw_half(QPainter& painter, const std::vector<session::RimPoint>& half, const QColor& colour,
                          Qt::PenStyle style) const {
    if (half.empty()) return;
    QPainterPath line;
    for (std::size_t i = 0; i < half.size(); ++i) {
        const QPointF at = place(half[i].direction_deg, half[i].radius_mm);
        i == 0 ? line.moveTo(at) : line.lineTo(at);
    }
    QPainterPath area = line;
    area.lineTo(place(0.0, 0.0));
    area.closeSubpath();
    QColor fill = colour;
    fill.setAlpha(kFill_alpha);
    painter.fillPath(area, fill);
    painter.setPen(QPen{colour, kLine_px, style});
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(line);
}

void PolarView::draw_mark(QPainter& painter, const std::vector<session::RimPoint>& half,
                          const QColor& colour) const {
    if (point_ >= half.size()) return;
    painter.setPen(QPen{tokens_->view, 1.5});
    painter.setBrush(colour);
    painter.drawEllipse(place(half[point_].direction_deg, half[point_].radius_mm), kMark_px, kMark_px);
}

void PolarView::draw_head(QPainter& painter, double direction_deg, const QColor& colour,
                          const QString& name) const {
    painter.save();
    painter.translate(place(direction_deg, most_mm_));
    painter.rotate(-direction_deg);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const QPointF tip[3] = {{-kHead_px, 0.0}, {kHead_px, -kHead_px * 0.7}, {kHead_px, kHead_px * 0.7}};
    painter.drawPolygon(tip, 3);
    painter.restore();
    painter.setPen(colour);
    const QPointF at = place(direction_deg, most_mm_ * 0.9);
    painter.drawText(QRectF{at.x() - 14, at.y() - 8, 28, 16}, Qt::AlignCenter, name);
}

}  // namespace psicarve::ui
