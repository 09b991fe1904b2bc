// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <cstddef>

#include "hmi/scene/radius_map.hpp"
#include "hmi/ui/tokens.hpp"

class QCPGraph;
class QCPItemStraightLine;
class QCustomPlot;

namespace psicarve::ui {

/// Both heads' radii over the table's angle along one layer, R1 solid, R2 dashed, with a line at a point.
class RadiusPlot : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::RadiusPlot)
public:
    explicit RadiusPlot(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_layer(const session::LayerCurves& curves);
    /// Requires a point of the layer that is shown.
    void mark(std::size_t point);
    /// Between the left rim and where the angle begins; between where it ends and the right rim.
    static constexpr int kLeftRoom_px = 44;
    static constexpr int kRightRoom_px = 14;

private:
    void colour();

    const Tokens* tokens_ = nullptr;
    session::LayerCurves curves_;
    std::size_t point_ = 0;
    QCustomPlot* plot_;
    QCPGraph* r1_;
    QCPGraph* r2_;
    QCPGraph* r1_mark_;
    QCPGraph* r2_mark_;
    QCPItemStraightLine* line_;
};

}  // namespace psicarve::ui
