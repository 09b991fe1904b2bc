// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/unrolled_view.hpp"

#include <QPainter>

#include "hmi/session/display_text.hpp"

namespace psicarve::ui {
namespace {

constexpr double kLeftRoom = 44.0;
constexpr double kTopRoom = 12.0;
constexpr double kRightRoom = 14.0;
constexpr double kBottomRoom = 62.0;
constexpr double kBarHeight = 12.0;
constexpr int kHeightLabels = 6;
constexpr int kQuarter_deg = 90;
constexpr int kTurn_deg = 360;

QString number(double value, int decimals) {
    return QString::fromStdString(session::number_text(value, decimals));
}

}  // namespace

UnrolledView::UnrolledView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(220, 200);
    setAccessibleName(tr("Radii of all layers, unrolled"));
}

void UnrolledView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    update();
}

void UnrolledView::show_map(const session::RadiusMap& map, double low_mm, double high_mm) {
    const auto picture = session::radius_picture(map, true);
    image_ = QImage{reinterpret_cast<const uchar*>(picture.data()), static_cast<int>(map.columns),
                    static_cast<int>(map.rows), QImage::Format_RGB32}
                 .copy();
    low_mm_ = low_mm;
    high_mm_ = high_mm;
    least_mm_ = map.least_mm;
    most_mm_ = map.most_mm;
    update();
}

void UnrolledView::mark(double height_ratio) {
    if (height_ratio == mark_ratio_) return;
    mark_ratio_ = height_ratio;
    update();
}

QRectF UnrolledView::map_area() const {
    return {kLeftRoom, kTopRoom, width() - kLeftRoom - kRightRoom, height() - kTopRoom - kBottomRoom};
}

void UnrolledView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    painter.fillRect(rect(), tokens_->view);
    if (image_.isNull()) return;
    const QRectF area = map_area();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, image_);
    QFont small = font();
    small.setPixelSize(11);
    painter.setFont(small);
    draw_axes(painter, area);
    draw_bar(painter, area);
    const double y = area.bottom() - mark_ratio_ * area.height();
    painter.setPen(QPen{Qt::white, 3.0});
    painter.drawLine(QPointF{area.left(), y}, QPointF{area.right(), y});
    painter.setPen(QPen{Qt::black, 1.0});
    painter.drawLine(QPointF{area.left(), y}, QPointF{area.right(), y});
}

void UnrolledView::draw_axes(QPainter& painter, const QRectF& area) const {
    painter.setPen(tokens_->text2);
    const bool is_low = high_mm_ - low_mm_ < kHeightLabels;
    for (int i = 0; i < kHeightLabels; ++i) {
        const double part = static_cast<double>(i) / (kHeightLabels - 1);
        const double y = area.bottom() - part * area.height();
        painter.drawText(QRectF{0, y - 8, kLeftRoom - 6, 16}, Qt::AlignRight | Qt::AlignVCenter,
                         number(low_mm_ + part * (high_mm_ - low_mm_), is_low ? 1 : 0));
    }
    for (int angle_deg = 0; angle_deg <= kTurn_deg; angle_deg += kQuarter_deg) {
        const double x = area.left() + area.width() * angle_deg / kTurn_deg;
        painter.drawText(QRectF{x - 20, area.bottom() + 2, 40, 16}, Qt::AlignCenter,
                         QString{"%1°"}.arg(angle_deg));
    }
}

void UnrolledView::draw_bar(QPainter& painter, const QRectF& area) const {
    const QRectF bar{area.left() + 40, area.bottom() + 34, area.width() - 80, kBarHeight};
    QLinearGradient colours{bar.topLeft(), bar.topRight()};
    constexpr int kStops = 16;
    for (int i = 0; i <= kStops; ++i) {
        const double ratio = static_cast<double>(i) / kStops;
        colours.setColorAt(ratio, QColor::fromRgb(session::viridis(ratio)));
    }
    painter.fillRect(bar, colours);
    painter.drawText(QRectF{bar.left() - 66, bar.top() - 3, 60, 18}, Qt::AlignRight | Qt::AlignVCenter,
                     tr("%1 mm").arg(number(least_mm_, 0)));
    painter.drawText(QRectF{bar.right() + 6, bar.top() - 3, 60, 18}, Qt::AlignLeft | Qt::AlignVCenter,
                     tr("%1 mm").arg(number(most_mm_, 0)));
}

}  // namespace psicarve::ui
