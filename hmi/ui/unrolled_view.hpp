// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QWidget>

#include <cstdint>

#include "hmi/session/radius_map.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// All layers unrolled: direction to the right, height up, radius as colour; a line at the layer that is
/// looked at.
class UnrolledView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::UnrolledView)
public:
    explicit UnrolledView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_map(const session::RadiusMap& map, double low_mm, double high_mm);
    /// 0 lowest, 1 highest layer.
    void mark(double height_ratio);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRectF map_area() const;
    void draw_axes(QPainter& painter, const QRectF& area) const;
    void draw_bar(QPainter& painter, const QRectF& area) const;

    const Tokens* tokens_ = nullptr;
    QImage image_;
    double low_mm_ = 0.0;
    double high_mm_ = 0.0;
    double least_mm_ = 0.0;
    double most_mm_ = 0.0;
    double mark_ratio_ = 0.0;
};

}  // namespace psicarve::ui
