// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/unrolled_view.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "hmi/session/display_text.hpp"

namespace psicarve::ui {
namespace {

constexpr double kLeastLeftRoom = 58.0;
constexpr double kBesideMark = 6.0;  // px
constexpr int kMostDecimals = 3;
constexpr int kSmallFont_px = 11;
constexpr double kTopRoom = 26.0;
constexpr double kHalfLine = 3.0;  // px
constexpr double kPointMark = 5.0;
constexpr double kLeastNamed = 24.0;  // px: narrower a half has no room for its name
constexpr double kRightRoom = 14.0;
constexpr double kBottomRoom = 62.0;
constexpr double kBarHeight = 12.0;
constexpr int kNoteRoom = 16;           // px
constexpr double kSquare = 10.0;        // px
constexpr double kBetweenKinds = 12.0;  // px
constexpr double kKeyBelow = 34.0;      // px, the map
constexpr double kFirstKeyBelow = 26.0;
constexpr double kKeyLine = 16.0;
constexpr double kLeastBetweenMarks = 36.0;  // px
constexpr double kMarkLength = 4.0;
constexpr int kQuarter_deg = 90;
constexpr int kUnrolledViewTurn_deg = 360;

QString number(double value, int decimals) {
    return QString::fromStdString(session::number_text(value, decimals));
}

}  // namespace

UnrolledView::UnrolledView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(220, 180);
    setAccessibleName(tr("All layers, unrolled"));
}

void UnrolledView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    update();
}

void UnrolledView::set_heights(double low_mm, double high_mm) {
    low_mm_ = low_mm;
    high_mm_ = high_mm;
    update();
}

void UnrolledView::show_map(const std::vector<std::uint32_t>& picture, std::size_t columns, MapKey key) {
    image_ = {};
    if (!picture.empty()) {
        const std::size_t rows = picture.size() / columns;
        image_ = QImage{reinterpret_cast<const uchar*>(picture.data()), static_cast<int>(columns),
                        static_cast<int>(rows), QImage::Format_RGB32}
                     .copy();
    }
    scaled_ = {};
    key_ = std::move(key);
    update();
}

void UnrolledView::mark_layer(double height_ratio, std::vector<session::HalfSpan> halves) {
    mark_ratio_ = height_ratio;
    halves_ = std::move(halves);
    update();
}

void UnrolledView::mark_point(double r1_direction_deg, double r2_direction_deg) {
    const std::array now{r1_direction_deg, r2_direction_deg};
    if (now == point_deg_) return;
    point_deg_ = now;
    update();
}

QFont UnrolledView::small_font() const {
    QFont small = font();
    small.setPixelSize(kSmallFont_px);
    return small;
}

session::RoundMarks UnrolledView::height_marks() const {
    const double room = height() - kTopRoom - kBottomRoom;
    session::RoundMarks marks =
        session::round_marks(low_mm_, high_mm_, std::max(2, static_cast<int>(room / kLeastBetweenMarks)));
    marks.decimals = std::min(marks.decimals, kMostDecimals);
    return marks;
}

double UnrolledView::left_room() const {
    const QFontMetricsF metrics{small_font()};
    const session::RoundMarks marks = height_marks();
    double room = kLeastLeftRoom;
    for (const double height_mm : marks.values) {
        const QString name = tr("%1 mm").arg(number(height_mm, marks.decimals));
        room = std::max(room, std::ceil(metrics.horizontalAdvance(name)) + 2.0 * kBesideMark);
    }
    return room;
}

QRectF UnrolledView::map_area() const {
    const double left = left_room();
    return {left, kTopRoom, width() - left - kRightRoom, height() - kTopRoom - kBottomRoom};
}

void UnrolledView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    painter.fillRect(rect(), tokens_->view);
    const QRectF area = map_area();
    if (image_.isNull()) {
        painter.setPen(tokens_->text2);
        return painter.drawText(rect().adjusted(kNoteRoom, 0, -kNoteRoom, 0),
                                Qt::AlignCenter | Qt::TextWordWrap, key_.low);
    }
    draw_map(painter, area);
    painter.setFont(small_font());
    draw_axes(painter, area);
    draw_bar(painter, area);
    draw_halves(painter, area);
    draw_layer(painter, area);
}

/// Scaling it takes longer than all the rest, and only its size changes it.
void UnrolledView::draw_map(QPainter& painter, const QRectF& area) {
    const QSize size = (area.size() * devicePixelRatioF()).toSize();
    if (size.isEmpty()) return;
    if (scaled_.size() != size)
        scaled_ = QPixmap::fromImage(image_.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    painter.drawPixmap(area, scaled_, scaled_.rect());
}

/// Which half is whose in this layer; where they meet it is true of the others, too, but for the sides.
void UnrolledView::draw_halves(QPainter& painter, const QRectF& area) const {
    const auto x_of = [&area](double angle_deg) {
        return area.left() + area.width() * angle_deg / kUnrolledViewTurn_deg;
    };
    for (const session::HalfSpan& span : halves_) {
        const QRectF head{x_of(span.from_deg), 0.0, x_of(span.to_deg) - x_of(span.from_deg), area.top()};
        const QColor& colour = span.is_r2 ? tokens_->r2 : tokens_->r1;
        painter.setPen(QPen{colour, kHalfLine, span.is_r2 ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap});
        const double y = area.top() - kHalfLine;
        painter.drawLine(QPointF{head.left() + 1.0, y}, QPointF{head.right() - 1.0, y});
        const QString name = span.is_r2 ? tr("R2 half") : tr("R1 half");
        const bool is_wide = painter.fontMetrics().horizontalAdvance(name) < head.width();
        if (head.width() > kLeastNamed)
            painter.drawText(head.adjusted(0, 0, 0, -2.0 * kHalfLine), Qt::AlignCenter,
                             is_wide ? name : name.left(2));
        if (span.from_deg == 0.0) continue;
        painter.setPen(QPen{Qt::white, 1.0});
        painter.drawLine(QPointF{head.left(), area.top()}, QPointF{head.left(), area.bottom()});
    }
}

void UnrolledView::draw_layer(QPainter& painter, const QRectF& area) const {
    const double y = area.bottom() - mark_ratio_ * area.height();
    for (const QPen& pen : {QPen{Qt::white, 3.0}, QPen{Qt::black, 1.0}}) {
        painter.setPen(pen);
        painter.drawLine(QPointF{area.left(), y}, QPointF{area.right(), y});
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen{Qt::white, 2.0});
    for (const bool is_r2 : {false, true}) {
        painter.setBrush(is_r2 ? tokens_->r2 : tokens_->r1);
        const double x = area.left() + area.width() * point_deg_[is_r2 ? 1 : 0] / kUnrolledViewTurn_deg;
        painter.drawEllipse(QPointF{x, y}, kPointMark, kPointMark);
    }
}

void UnrolledView::draw_axes(QPainter& painter, const QRectF& area) const {
    painter.setPen(tokens_->text2);
    const double extent_mm = high_mm_ - low_mm_;
    const session::RoundMarks marks = height_marks();
    for (const double height_mm : marks.values) {
        const double part = extent_mm > 0.0 ? (height_mm - low_mm_) / extent_mm : 0.0;
        const double y = area.bottom() - part * area.height();
        painter.drawLine(QPointF{area.left() - kMarkLength, y}, QPointF{area.left(), y});
        painter.drawText(QRectF{0, y - 8, area.left() - kBesideMark, 16}, Qt::AlignRight | Qt::AlignVCenter,
                         tr("%1 mm").arg(number(height_mm, marks.decimals)));
    }
    for (int angle_deg = 0; angle_deg <= kUnrolledViewTurn_deg; angle_deg += kQuarter_deg) {
        const double x = area.left() + area.width() * angle_deg / kUnrolledViewTurn_deg;
        painter.drawLine(QPointF{x, area.bottom()}, QPointF{x, area.bottom() + kMarkLength});
        painter.drawText(QRectF{x - 20, area.bottom() + kMarkLength, 40, 16}, Qt::AlignCenter,
                         QString{"%1°"}.arg(angle_deg));
    }
}

/// In two lines where one is too narrow for them.
void UnrolledView::draw_kinds(QPainter& painter, const QRectF& area) const {
    const QFontMetricsF metrics{painter.font()};
    const double right = this->width() - kBesideMark;
    std::vector<double> widths;
    for (const auto& [colour, name] : key_.kinds)
        widths.push_back(kSquare + kBesideMark + metrics.horizontalAdvance(name) + kBetweenKinds);
    const double whole = std::accumulate(widths.begin(), widths.end(), -kBetweenKinds);
    const bool is_wide = whole <= right - kBesideMark;
    double x =
        is_wide ? std::clamp(area.center().x() - whole / 2.0, kBesideMark, right - whole) : kBesideMark;
    double y = area.bottom() + (is_wide ? kKeyBelow : kFirstKeyBelow);
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const auto& [colour, name] = key_.kinds[i];
        if (i > 0 && x + widths[i] - kBetweenKinds > right) {
            x = kBesideMark;
            y += kKeyLine;
        }
        const QRectF square{x, y + 1.0, kSquare, kSquare};
        painter.fillRect(square, colour);
        painter.drawRect(square);
        painter.drawText(QRectF{x + kSquare + kBesideMark, y - 3.0, widths[i], 18},
                         Qt::AlignLeft | Qt::AlignVCenter, name);
        x += widths[i];
    }
}

void UnrolledView::draw_bar(QPainter& painter, const QRectF& area) const {
    if (!key_.kinds.empty()) return draw_kinds(painter, area);
    const QRectF bar{area.left() + 40, area.bottom() + kKeyBelow, area.width() - 80, kBarHeight};
    QLinearGradient colours{bar.topLeft(), bar.topRight()};
    constexpr int kStops = 16;
    for (int i = 0; i <= kStops; ++i) {
        const double ratio = static_cast<double>(i) / kStops;
        colours.setColorAt(ratio, QColor::fromRgb(session::viridis(ratio)));
    }
    painter.fillRect(bar, colours);
    painter.drawText(QRectF{bar.left() - 66, bar.top() - 3, 60, 18}, Qt::AlignRight | Qt::AlignVCenter,
                     key_.low);
    painter.drawText(QRectF{bar.right() + 6, bar.top() - 3, 60, 18}, Qt::AlignLeft | Qt::AlignVCenter,
                     key_.high);
}

}  // namespace psicarve::ui
