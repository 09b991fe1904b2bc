// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/connector_view.hpp"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kHeight_px = 104;
constexpr int kPinText_px = 10;
constexpr double kRadius_px = 8.0;
constexpr double kRing_px = 12.0;  // round a switch that stops the machine
constexpr double kUpperRow_px = 38.0;
constexpr double kLowerRow_px = 64.0;
constexpr double kMostPitch_px = 62.0;
constexpr int kFirstGround = 18;

}  // namespace

ConnectorView::ConnectorView(QWidget* parent) : QWidget(parent) {
    setFixedHeight(kHeight_px);
    setAccessibleName(
        QCoreApplication::translate("psicarve::ui::ConnectorView", "The connector's pins and their levels"));
}

void ConnectorView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    update();
}

void ConnectorView::show_rows(const std::vector<session::PinRow>& rows) {
    signals_.fill(0);
    labels_.fill({});
    std::array<std::vector<Signal>, kPins + 1> at_pin;
    for (const session::PinRow& row : rows) {
        if (row.pin < 1 || row.pin > kPins) continue;
        const auto pin = static_cast<std::size_t>(row.pin);
        signals_[pin] |= bit_of(row.signal);
        at_pin[pin].push_back(row.signal);
    }
    for (std::size_t pin = 1; pin <= kPins; ++pin) labels_[pin] = words(session::pin_label(at_pin[pin]));
    for (std::size_t pin = kFirstGround; pin <= kPins; ++pin)
        labels_[pin] = QCoreApplication::translate("psicarve::ui::ConnectorView", "ground");
    update();
}

void ConnectorView::show_levels(SignalWord levels) {
    if (levels == levels_) return;
    levels_ = levels;
    update();
}

/// A ring round the pin of a switch that stops the machine, and its name in the same colour.
void ConnectorView::draw_tripped(QPainter& painter) const {
    const SignalWord tripped = session::tripped_stops(levels_);
    painter.setPen(QPen{tokens_->alarm, 2.5});
    painter.setBrush(Qt::NoBrush);
    for (int pin = 1; pin <= kPins; ++pin) {
        if ((signals_[static_cast<std::size_t>(pin)] & tripped) != 0)
            painter.drawEllipse(centre_of(pin), kRing_px, kRing_px);
    }
}

QPointF ConnectorView::centre_of(int pin) const {
    const double pitch = std::min(kMostPitch_px, (width() - 40.0) / kUpperPins);
    const double left = width() / 2.0 - pitch * (kUpperPins - 1) / 2.0;
    if (pin <= kUpperPins) return {left + pitch * (pin - 1), kUpperRow_px};
    return {left + pitch * (pin - kUpperPins - 0.5), kLowerRow_px};
}

void ConnectorView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    QFont small = font();
    small.setPixelSize(kPinText_px);
    painter.setFont(small);
    const double rim = 1.7 * kRadius_px;
    QPainterPath shell;
    shell.moveTo(centre_of(1) + QPointF{-2.2 * kRadius_px, -rim});
    shell.lineTo(centre_of(kUpperPins) + QPointF{2.2 * kRadius_px, -rim});
    shell.lineTo(centre_of(kPins) + QPointF{2.2 * kRadius_px, rim});
    shell.lineTo(centre_of(kUpperPins + 1) + QPointF{-2.2 * kRadius_px, rim});
    shell.closeSubpath();
    painter.setPen(QPen{tokens_->edge, 1.2});
    painter.setBrush(tokens_->view);
    painter.drawPath(shell);
    const double pitch = centre_of(2).x() - centre_of(1).x();
    const QFontMetrics metrics{small};
    for (int pin = 1; pin <= kPins; ++pin) {
        const auto index = static_cast<std::size_t>(pin);
        const QPointF centre = centre_of(pin);
        const bool is_used = signals_[index] != 0;
        const bool is_high = (signals_[index] & levels_) != 0;
        painter.setPen(QPen{is_used ? tokens_->text : tokens_->line, 1.2});
        painter.setBrush(is_high ? QBrush{tokens_->text} : QBrush{Qt::NoBrush});
        painter.drawEllipse(centre, kRadius_px, kRadius_px);
        painter.setPen(is_high ? tokens_->win : is_used ? tokens_->text : tokens_->dis);
        painter.drawText(QRectF{centre.x() - 12.0, centre.y() - 8.0, 24.0, 16.0}, Qt::AlignCenter,
                         QString::number(pin));
        const bool is_tripped = (signals_[index] & session::tripped_stops(levels_)) != 0;
        painter.setPen(is_tripped ? tokens_->alarm : is_used ? tokens_->text2 : tokens_->dis);
        const double y = pin <= kUpperPins ? 4.0 : kHeight_px - 20.0;
        const QString label = metrics.elidedText(labels_[index], Qt::ElideRight, static_cast<int>(pitch) - 3);
        painter.drawText(QRectF{centre.x() - pitch / 2.0, y, pitch, 16.0}, Qt::AlignCenter, label);
    }
    draw_tripped(painter);
}

}  // namespace psicarve::ui
