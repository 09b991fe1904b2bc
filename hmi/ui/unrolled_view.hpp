// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "hmi/scene/radius_map.hpp"
#include "hmi/session/round_marks.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// What an unrolled map's colours mean: named ones, or a scale from one end to the other.
struct MapKey {
    QString low;
    QString high;
    std::vector<std::pair<QColor, QString>> kinds;  ///< empty: a scale
};

/// All layers unrolled: direction to the right, height up, one of their properties as colour. A line at the
/// layer that is looked at, above it which head carves what of it, and on it both heads at the point that is
/// looked at.
class UnrolledView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::UnrolledView)
public:
    explicit UnrolledView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    /// The heights of the lowest and the highest layer.
    void set_heights(double low_mm, double high_mm);
    /// `picture`: columns * rows, 0xFFRRGGBB, highest layer first; empty: `key.low` says why there is none.
    void show_map(const std::vector<std::uint32_t>& picture, std::size_t columns, MapKey key);
    const MapKey& key() const noexcept { return key_; }
    /// `height_ratio`: 0 lowest, 1 highest layer.
    void mark_layer(double height_ratio, std::vector<session::HalfSpan> halves);
    /// Where R1 and R2 are on it.
    void mark_point(double r1_direction_deg, double r2_direction_deg);

    /// Where the map is in it: beside the widest of the heights' names.
    QRectF map_area() const;
    /// The heights that are named.
    session::RoundMarks height_marks() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QFont small_font() const;
    double left_room() const;
    void draw_map(QPainter& painter, const QRectF& area);
    void draw_halves(QPainter& painter, const QRectF& area) const;
    void draw_layer(QPainter& painter, const QRectF& area) const;
    void draw_axes(QPainter& painter, const QRectF& area) const;
    void draw_bar(QPainter& painter, const QRectF& area) const;
    void draw_kinds(QPainter& painter, const QRectF& area) const;

    const Tokens* tokens_ = nullptr;
    QImage image_;
    QPixmap scaled_;  ///< of image_, as large as it is shown
    double low_mm_ = 0.0;
    double high_mm_ = 0.0;
    MapKey key_;
    double mark_ratio_ = 0.0;
    std::vector<session::HalfSpan> halves_;
    std::array<double, 2> point_deg_{};  ///< R1, R2
};

}  // namespace psicarve::ui
