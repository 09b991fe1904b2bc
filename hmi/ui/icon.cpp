// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/icon.hpp"

#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <initializer_list>

namespace psicarve::ui {
namespace {

// On a grid of 16.
constexpr double kGrid = 16.0;
constexpr double kStroke = 1.75;

QPainterPath lines(std::initializer_list<QPointF> points, bool is_closed = false) {
    QPainterPath path;
    bool is_first = true;
    for (const QPointF& point : points) {
        if (is_first) path.moveTo(point);
        if (!is_first) path.lineTo(point);
        is_first = false;
    }
    if (is_closed) path.closeSubpath();
    return path;
}

QPainterPath ring() {
    QPainterPath path;
    path.addEllipse(QPointF{8, 8}, 6.3, 6.3);
    return path;
}

QPainterPath octagon_path() {
    return lines({{5.4, 1.8},
                  {10.6, 1.8},
                  {14.2, 5.4},
                  {14.2, 10.6},
                  {10.6, 14.2},
                  {5.4, 14.2},
                  {1.8, 10.6},
                  {1.8, 5.4}},
                 true);
}

QPainterPath exclamation() {
    QPainterPath path = lines({{8, 4.8}, {8, 8.8}});
    path.addEllipse(QPointF{8, 11.3}, 0.35, 0.35);
    return path;
}

QPainterPath turn(bool to_left) {
    QPainterPath path;
    path.arcMoveTo(QRectF{2.8, 3.2, 10.4, 10.4}, to_left ? 20 : 160);
    path.arcTo(QRectF{2.8, 3.2, 10.4, 10.4}, to_left ? 20 : 160, to_left ? 180 : -180);
    path.addPath(to_left ? lines({{0.8, 6.4}, {2.8, 9.2}, {5.4, 7.2}})
                         : lines({{15.2, 6.4}, {13.2, 9.2}, {10.6, 7.2}}));
    return path;
}

QPainterPath with(QPainterPath a, const QPainterPath& b) {
    a.addPath(b);
    return a;
}

QPainterPath stroked(Glyph glyph) {
    switch (glyph) {
        case Glyph::check:
            return lines({{2.5, 8.5}, {6.3, 12.2}, {13.5, 4.2}});
        case Glyph::cross:
            return with(lines({{3.5, 3.5}, {12.5, 12.5}}), lines({{12.5, 3.5}, {3.5, 12.5}}));
        case Glyph::info: {
            QPainterPath path = with(ring(), lines({{8, 7.6}, {8, 11.2}}));
            path.addEllipse(QPointF{8, 4.9}, 0.35, 0.35);
            return path;
        }
        case Glyph::triangle:
            return with(lines({{8, 1.8}, {14.6, 13.6}, {1.4, 13.6}}, true), exclamation().translated(0, 0.4));
        case Glyph::octagon:
            return with(octagon_path(), exclamation());
        case Glyph::circle_check:
            return with(ring(), lines({{5, 8.2}, {7.2, 10.4}, {11.2, 5.8}}));
        case Glyph::unplugged:
            return with(with(lines({{1.5, 8}, {4.5, 8}}), lines({{4.5, 4.8}, {4.5, 11.2}})),
                        with(lines({{14.5, 8}, {10.5, 8}}),
                             lines({{10.5, 4.8}, {10.5, 11.2}, {8, 11.2}, {8, 4.8}}, true)));
        case Glyph::menu:
            return with(with(lines({{2.5, 4}, {13.5, 4}}), lines({{2.5, 8}, {13.5, 8}})),
                        lines({{2.5, 12}, {13.5, 12}}));
        case Glyph::left:
            return with(lines({{13.5, 8}, {2.5, 8}}), lines({{6.5, 4}, {2.5, 8}, {6.5, 12}}));
        case Glyph::right:
            return with(lines({{2.5, 8}, {13.5, 8}}), lines({{9.5, 4}, {13.5, 8}, {9.5, 12}}));
        case Glyph::up:
            return with(lines({{8, 13.5}, {8, 2.5}}), lines({{4, 6.5}, {8, 2.5}, {12, 6.5}}));
        case Glyph::down:
            return with(lines({{8, 2.5}, {8, 13.5}}), lines({{4, 9.5}, {8, 13.5}, {12, 9.5}}));
        case Glyph::turn_left:
            return turn(true);
        case Glyph::turn_right:
            return turn(false);
        case Glyph::lock:
            return with(lines({{3.5, 7.5}, {12.5, 7.5}, {12.5, 13.5}, {3.5, 13.5}}, true),
                        lines({{5.5, 7.5}, {5.5, 4}, {8, 2.5}, {10.5, 4}, {10.5, 7.5}}));
        case Glyph::replay:
            return with(turn(true), lines({{8, 5.2}, {8, 8.4}, {10.2, 9.6}}));
        case Glyph::to_begin:
            return with(lines({{3.5, 3}, {3.5, 13}}), lines({{12.5, 3}, {6.5, 8}, {12.5, 13}}, true));
        case Glyph::to_end:
            return with(lines({{12.5, 3}, {12.5, 13}}), lines({{3.5, 3}, {9.5, 8}, {3.5, 13}}, true));
        case Glyph::entry_before:
            return with(lines({{13, 8}, {13, 8.1}}), lines({{9.5, 3.5}, {4.5, 8}, {9.5, 12.5}}));
        case Glyph::next_entry:
            return with(lines({{3, 8}, {3, 8.1}}), lines({{6.5, 3.5}, {11.5, 8}, {6.5, 12.5}}));
        default:
            return {};
    }
}

QPainterPath filled(Glyph glyph) {
    QPainterPath path;
    if (glyph == Glyph::play) path = lines({{4, 2.5}, {13.5, 8}, {4, 13.5}}, true);
    if (glyph == Glyph::stop) path.addRoundedRect(QRectF{3.5, 3.5, 9, 9}, 1, 1);
    if (glyph == Glyph::pause) {
        path.addRect(QRectF{3.8, 3, 3, 10});
        path.addRect(QRectF{9.2, 3, 3, 10});
    }
    return path;
}

}  // namespace

void draw_glyph(QPainter& painter, Glyph glyph, double side, const QColor& colour) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(side / kGrid, side / kGrid);
    const QPainterPath solid = filled(glyph);
    if (!solid.isEmpty()) {
        painter.fillPath(solid, colour);
    } else {
        painter.setPen(QPen{colour, kStroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(stroked(glyph));
    }
    painter.restore();
}

QPixmap glyph_pixmap(Glyph glyph, int side, const QColor& colour) {
    const double ratio = qApp->devicePixelRatio();
    QPixmap pixmap{qRound(side * ratio), qRound(side * ratio)};
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter{&pixmap};
    draw_glyph(painter, glyph, side, colour);
    return pixmap;
}

QIcon glyph_icon(Glyph glyph, const QColor& colour, const QColor& disabled) {
    constexpr int kSide = 16;
    QIcon icon{glyph_pixmap(glyph, kSide, colour)};
    icon.addPixmap(glyph_pixmap(glyph, kSide, disabled), QIcon::Disabled);
    return icon;
}

Glyph glyph_of(MachineState state, bool has_core) noexcept {
    if (!has_core) return Glyph::unplugged;
    switch (state) {
        case MachineState::off:
            return Glyph::info;
        case MachineState::ready:
        case MachineState::waiting:
            return Glyph::circle_check;
        case MachineState::holding:
        case MachineState::held:
            return Glyph::pause;
        case MachineState::stopping:
        case MachineState::testing:
            return Glyph::triangle;
        case MachineState::alarm:
        case MachineState::backing_off:
            return Glyph::octagon;
        default:
            return Glyph::play;
    }
}

}  // namespace psicarve::ui
