// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <cstddef>
#include <optional>

#include "hmi/scene/radius_map.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// One layer seen from above: R1's half solid, R2's dashed, and where the heads are.
class PolarView : public QWidget {
public:
    explicit PolarView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    /// `most_mm`: what the outer circle stands for, the same for all layers.
    void show_rim(session::LayerRim rim, double most_mm);
    /// Marks this point of both halves. Requires a point of the rim, or none is marked.
    void mark(std::size_t point);
    /// The workpiece direction that R1 faces; nothing: the heads are elsewhere.
    void show_heads(std::optional<double> r1_direction_deg);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QPointF place(double direction_deg, double radius_mm) const;
    void draw_grid(QPainter& painter) const;
    void draw_half(QPainter& painter, const std::vector<session::RimPoint>& half, const QColor& colour,
                   Qt::PenStyle style) const;
    void draw_mark(QPainter& painter, const std::vector<session::RimPoint>& half, const QColor& colour) const;
    void draw_head(QPainter& painter, double direction_deg, const QColor& colour, const QString& name) const;

    const Tokens* tokens_ = nullptr;
    session::LayerRim rim_;
    double most_mm_ = 1.0;
    std::size_t point_ = 0;
    std::optional<double> r1_direction_deg_;
};

}  // namespace psicarve::ui
