// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/program_path_view.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include "hmi/session/display_text.hpp"
#include "hmi/session/round_marks.hpp"

namespace psicarve::ui {
namespace {

using program::SketchPoint;

constexpr double kPathTurn_deg = 360.0;
constexpr int kPathScaleLeft_px = 44;
constexpr int kPathScaleBelow_px = 34;
constexpr int kPathBorder_px = 10;
constexpr double kPathLine_px = 1.0;
constexpr double kPathMark_px = 3.0;
constexpr double kPathMarkDot_px = 4.0;
constexpr double kPathLeast_mm = 1.0;
constexpr std::size_t kMostSmoothPieces = 8'000;  // a frame must not take long
constexpr int kMostPathMarks = 5;
constexpr double kPathMarkRoom_px = 40.0;
/// The lines of more turns than these lie so close that they are one band.
constexpr double kMostTurnsDrawn = 2.0;
constexpr double kBandOpacity = 0.5;

double place_of(const SketchPoint& point, Axis axis) {
    return point.place[index_of(axis)];
}

}  // namespace

ProgramPathView::ProgramPathView(QWidget* parent) : QWidget(parent) {
    setObjectName("program_path");
    setAccessibleName(tr("The program's path; rapid moves are dashed"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ProgramPathView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    drawn_ = {};
    update();
}

void ProgramPathView::show_program(const program::DecodedPointer& program) {
    if (program == program_) return;
    program_ = program;
    fit();
}

void ProgramPathView::show_plane(Plane plane) {
    plane_ = plane;
    fit();
}

void ProgramPathView::fit() {
    shown_ = extent();
    drawn_ = {};
    marked_ = program_ ? program::piece_of_line(program_->path, line_) : 0;
    update();
}

void ProgramPathView::mark_line(std::uint64_t line) {
    if (line == line_) return;
    line_ = line;
    const std::size_t piece = program_ ? program::piece_of_line(program_->path, line_) : 0;
    if (piece != marked_) update();
    marked_ = piece;
}

Axis ProgramPathView::across() const noexcept {
    return plane_ == Plane::r1 ? Axis::r1 : plane_ == Plane::r2 ? Axis::r2 : Axis::psi;
}

bool ProgramPathView::is_drawn(const SketchPoint& point) const noexcept {
    const unsigned both = 1U << index_of(across()) | 1U << index_of(Axis::y);
    return (point.placed & both) == both;
}

std::size_t ProgramPathView::drawn_pieces() const {
    if (!program_ || program_->path.empty()) return 0;
    return static_cast<std::size_t>(
        std::count_if(program_->path.begin() + 1, program_->path.end(),
                      [this](const SketchPoint& point) { return is_drawn(point); }));
}

ProgramPathView::Extent ProgramPathView::extent() const {
    Extent found{1e300, -1e300, 1e300, -1e300};
    const auto note = [&](const SketchPoint& point) {
        found.left = std::min(found.left, place_of(point, across()));
        found.right = std::max(found.right, place_of(point, across()));
        found.low = std::min(found.low, place_of(point, Axis::y));
        found.high = std::max(found.high, place_of(point, Axis::y));
    };
    for (std::size_t i = 1; program_ && i < program_->path.size(); ++i) {
        if (!is_drawn(program_->path[i])) continue;
        note(program_->path[i - 1]);
        note(program_->path[i]);
    }
    if (found.left > found.right) return {0.0, kPathLeast_mm, 0.0, kPathLeast_mm};
    const auto widen = [](double& least, double& most) {
        const double room = std::max(0.04 * (most - least), kPathLeast_mm / 2.0);
        least -= room;
        most += room;
    };
    widen(found.left, found.right);
    widen(found.low, found.high);
    if (plane_ == Plane::unrolled) {
        found.left = 0.0;
        found.right = kPathTurn_deg;
    }
    return found;
}

/// Of a head's plane mm are as long in both directions.
QRectF ProgramPathView::area() const {
    const QRectF room =
        QRectF{rect()}.adjusted(kPathScaleLeft_px, kPathBorder_px, -kPathBorder_px, -kPathScaleBelow_px);
    if (plane_ == Plane::unrolled) return room;
    const double wide = shown_.right - shown_.left;
    const double high = shown_.high - shown_.low;
    const double px_per_mm = std::min(room.width() / wide, room.height() / high);
    QRectF fitted{0.0, 0.0, wide * px_per_mm, high * px_per_mm};
    fitted.moveCenter(room.center());
    return fitted;
}

QPointF ProgramPathView::at(double across, double y_mm) const {
    const QRectF room = area();
    return {room.left() + room.width() * (across - shown_.left) / (shown_.right - shown_.left),
            room.bottom() - room.height() * (y_mm - shown_.low) / (shown_.high - shown_.low)};
}

void ProgramPathView::draw_piece(QPainter& painter, std::size_t piece) const {
    const SketchPoint& from = program_->path[piece - 1];
    const SketchPoint& to = program_->path[piece];
    if (!is_drawn(to)) return;
    if (plane_ != Plane::unrolled) {
        painter.drawLine(at(place_of(from, across()), place_of(from, Axis::y)),
                         at(place_of(to, across()), place_of(to, Axis::y)));
        return;
    }
    // Cut at whole turns.
    const double begin_deg = place_of(from, Axis::psi);
    const double sweep_deg = place_of(to, Axis::psi) - begin_deg;
    const double y_mm = place_of(from, Axis::y);
    const double rise_mm = place_of(to, Axis::y) - y_mm;
    if (std::abs(sweep_deg) > kMostTurnsDrawn * kPathTurn_deg) {
        QRectF band = QRectF{at(0.0, y_mm), at(kPathTurn_deg, y_mm + rise_mm)}.normalized();
        band.setHeight(std::max(band.height(), kPathLine_px));
        QColor colour = painter.pen().color();
        colour.setAlphaF(kBandOpacity);
        return painter.fillRect(band, colour);
    }
    const double least_deg = std::min(begin_deg, begin_deg + sweep_deg);
    const double most_deg = std::max(begin_deg, begin_deg + sweep_deg);
    const double first = std::floor(least_deg / kPathTurn_deg);
    const double last = std::max(std::ceil(most_deg / kPathTurn_deg), first + 1.0);
    const int turns = static_cast<int>(last - first);
    for (int i = 0; i < turns; ++i) {
        const double turn = first + i;
        const double low_deg = std::max(least_deg, turn * kPathTurn_deg);
        const double high_deg = std::min(most_deg, (turn + 1.0) * kPathTurn_deg);
        const auto y_at = [&](double angle_deg) {
            return sweep_deg == 0.0 ? y_mm : y_mm + rise_mm * (angle_deg - begin_deg) / sweep_deg;
        };
        const double end_mm = sweep_deg == 0.0 ? y_mm + rise_mm : y_at(high_deg);
        painter.drawLine(at(low_deg - turn * kPathTurn_deg, y_at(low_deg)),
                         at(high_deg - turn * kPathTurn_deg, end_mm));
    }
}

void ProgramPathView::draw_scales(QPainter& painter) const {
    const QRectF room = area();
    QFont small = font();
    small.setPixelSize(kSmallText_px);
    painter.setFont(small);
    const auto text = [](double value, int decimals) {
        return QString::fromStdString(session::number_text(value, decimals));
    };
    const auto marks = [](double low, double high, double room_px) {
        const int most = std::clamp(static_cast<int>(room_px / kPathMarkRoom_px), 1, kMostPathMarks);
        return session::round_marks(low, high, most);
    };
    const session::RoundMarks heights = marks(shown_.low, shown_.high, room.height());
    const session::RoundMarks widths = marks(shown_.left, shown_.right, room.width());
    for (const double y_mm : heights.values) {
        const double y = at(shown_.left, y_mm).y();
        painter.setPen(tokens_->line);
        painter.drawLine(QPointF{room.left(), y}, QPointF{room.right(), y});
        painter.setPen(tokens_->text2);
        painter.drawText(QRectF{room.left() - kPathScaleLeft_px, y - 8.0, kPathScaleLeft_px - 4.0, 16.0},
                         Qt::AlignRight | Qt::AlignVCenter, text(y_mm, heights.decimals));
    }
    for (const double across : widths.values) {
        const double x = at(across, shown_.low).x();
        painter.setPen(tokens_->line);
        painter.drawLine(QPointF{x, room.top()}, QPointF{x, room.bottom()});
        painter.setPen(tokens_->text2);
        painter.drawText(QRectF{x - 30.0, room.bottom() + 2.0, 60.0, 14.0}, Qt::AlignCenter,
                         text(across, widths.decimals));
    }
    const QString name = plane_ == Plane::r1   ? tr("R1 / mm, Y upwards / mm")
                         : plane_ == Plane::r2 ? tr("R2 / mm, Y upwards / mm")
                                               : tr("Ψ / °, Y upwards / mm");
    painter.drawText(QRectF{0.0, height() - 18.0, static_cast<double>(width()), 16.0}, Qt::AlignCenter, name);
}

void ProgramPathView::draw_path() {
    const double ratio = devicePixelRatioF();
    drawn_ = QPixmap{size() * ratio};
    drawn_.setDevicePixelRatio(ratio);
    drawn_.fill(tokens_->view);
    QPainter painter{&drawn_};
    if (drawn_pieces() == 0) {
        painter.setPen(tokens_->text2);
        return painter.drawText(rect().adjusted(kPathBorder_px, 0, -kPathBorder_px, 0),
                                Qt::AlignCenter | Qt::TextWordWrap,
                                program_ ? tr("Nothing moves in this plane.") : QString{});
    }
    draw_scales(painter);
    // Neither smooth lines nor dashes: of so many none is seen by itself.
    const bool is_crowded = program_->path.size() >= kMostSmoothPieces;
    painter.setRenderHint(QPainter::Antialiasing, !is_crowded);
    const QColor colour = plane_ == Plane::r1   ? tokens_->r1
                          : plane_ == Plane::r2 ? tokens_->r2
                                                : tokens_->text;
    for (std::size_t i = 1; i < program_->path.size(); ++i) {
        const bool is_rapid = program_->path[i].is_rapid;
        painter.setPen(QPen{is_rapid ? tokens_->text2 : colour, kPathLine_px,
                            is_rapid && !is_crowded ? Qt::DashLine : Qt::SolidLine});
        draw_piece(painter, i);
    }
}

void ProgramPathView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    if (drawn_.isNull() || drawn_.deviceIndependentSize().toSize() != size()) draw_path();
    QPainter painter{this};
    painter.drawPixmap(0, 0, drawn_);
    if (marked_ == 0 || !is_drawn(program_->path[marked_])) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen{tokens_->run, kPathMark_px, Qt::SolidLine, Qt::RoundCap});
    draw_piece(painter, marked_);
    const SketchPoint& end = program_->path[marked_];
    const double across_end =
        plane_ == Plane::unrolled
            ? place_of(end, across()) - kPathTurn_deg * std::floor(place_of(end, across()) / kPathTurn_deg)
            : place_of(end, across());
    painter.setBrush(tokens_->run);
    painter.drawEllipse(at(across_end, place_of(end, Axis::y)), kPathMarkDot_px, kPathMarkDot_px);
}

}  // namespace psicarve::ui
