// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/pass_view.hpp"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <utility>

#include "hmi/session/display_text.hpp"

namespace psicarve::ui {
namespace {

constexpr double kPassLine_px = 1.4;
constexpr double kLeastStep_px = 3.0;  // depths closer than this would be a grey area
constexpr int kToolFill_alpha = 60;
constexpr int kShank_alpha = 25;
constexpr int kBorder_px = 3;

}  // namespace

PassView::PassView(QWidget* parent) : QWidget(parent) {
    setObjectName("pass_view");
    setFixedHeight(static_cast<int>(kWidth_px * kRatio));
    setAccessibleName(tr("The blank, the passes' depths and the tool, to scale"));
    setToolTip(accessibleName());
}

void PassView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    update();
}

void PassView::show_sketch(session::PassSketch sketch) {
    sketch_ = std::move(sketch);
    update();
}

/// The axis stands at the right, for the left head's tool comes from the left.
QPointF PassView::place(const session::SketchPoint& point) const {
    const double px_per_mm = width() / sketch_.width_mm;
    return {width() - point.radius_mm * px_per_mm, height() - point.height_mm * px_per_mm};
}

QPolygonF PassView::polygon(const std::vector<session::SketchPoint>& points) const {
    QPolygonF polygon;
    for (const session::SketchPoint& point : points) polygon << place(point);
    return polygon;
}

void PassView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), tokens_->view);
    if (!(sketch_.width_mm > 0.0)) return;
    if (sketch_.blank_mm > 0.0) {
        draw_blank(painter);
        draw_depths(painter);
    }
    draw_tool(painter);
    draw_words(painter);
}

void PassView::draw_blank(QPainter& painter) const {
    QPolygonF body = polygon(sketch_.stock);
    body << place({0.0, sketch_.height_mm}) << place({0.0, 0.0});
    painter.setPen(Qt::NoPen);
    painter.setBrush(tokens_->line);
    painter.drawPolygon(body);
    painter.setPen(QPen{tokens_->text2, kPassLine_px});
    painter.drawPolyline(polygon(sketch_.stock));
    painter.setPen(QPen{tokens_->text2, 1.0, Qt::DashLine});
    for (const double radius_mm : {sketch_.blank_mm, 0.0})
        painter.drawLine(place({radius_mm, 0.0}), place({radius_mm, sketch_.height_mm}));
}

void PassView::draw_depths(QPainter& painter) const {
    painter.setPen(QPen{tokens_->text2, 1.0, Qt::DotLine});
    double before_px = place({sketch_.blank_mm, 0.0}).x();
    for (const double depth_mm : sketch_.depths_mm) {
        const double at_px = place({depth_mm, 0.0}).x();
        if (at_px - before_px < kLeastStep_px) continue;
        painter.drawLine(QPointF{at_px, 0.0}, QPointF{at_px, height() * 1.0});
        before_px = at_px;
    }
    painter.setPen(QPen{tokens_->run, kPassLine_px});
    painter.drawLine(place({sketch_.finished_mm, 0.0}), place({sketch_.finished_mm, sketch_.height_mm}));
}

void PassView::draw_tool(QPainter& painter) const {
    QColor fill = tokens_->r1;
    fill.setAlpha(kShank_alpha);
    painter.setPen(QPen{tokens_->r1, 1.0, Qt::DotLine});
    painter.setBrush(fill);
    painter.drawPolygon(polygon(sketch_.shank));
    fill.setAlpha(kToolFill_alpha);
    painter.setPen(QPen{tokens_->r1, kPassLine_px});
    painter.setBrush(fill);
    painter.drawPolygon(polygon(sketch_.tool));
}

void PassView::draw_words(QPainter& painter) const {
    QFont small = font();
    small.setPixelSize(kSmallText_px);
    painter.setFont(small);
    painter.setPen(tokens_->text);
    if (!(sketch_.blank_mm > 0.0)) return;
    const double surface_px = place({sketch_.blank_mm, 0.0}).x();
    const QString radius =
        QStringLiteral("r ") + QString::fromStdString(session::number_text(sketch_.blank_mm, 1));
    painter.drawText(QRectF{0.0, 0.0, surface_px - kBorder_px, 2.0 * kSmallText_px},
                     Qt::AlignRight | Qt::AlignVCenter, radius);
    painter.drawText(QRectF{0.0, 0.0, width() - 1.0 * kBorder_px, 2.0 * kSmallText_px},
                     Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("Ψ"));
}

}  // namespace psicarve::ui
