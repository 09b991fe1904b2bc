// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPixmap>
#include <QWidget>

#include <cstddef>
#include <cstdint>
#include <optional>

#include "hmi/program/decoding.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// A program's way: a head over Y, or the unrolled cylinder, C over Y. Rapid moves are dashed; the move of a
/// line is marked.
class ProgramPathView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ProgramPathView)
public:
    enum class Plane : std::uint8_t { r1, r2, unrolled };

    explicit ProgramPathView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    /// Null: none.
    void show_program(const program::DecodedPointer& program);
    void show_plane(Plane plane);
    Plane plane() const noexcept { return plane_; }
    /// 0: none.
    void mark_line(std::uint64_t line);
    /// The piece that is marked, from 1; 0: none.
    std::size_t marked_piece() const noexcept { return marked_; }
    /// What is drawn of the path: pieces whose both axes have a place.
    std::size_t drawn_pieces() const;

    QSize sizeHint() const override { return {260, 200}; }
    QSize minimumSizeHint() const override { return {180, 120}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// mm or degrees that the picture shows.
    struct Extent {
        double left = 0.0;
        double right = 0.0;
        double low = 0.0;
        double high = 0.0;
    };
    Axis across() const noexcept;
    bool is_drawn(const program::SketchPoint& point) const noexcept;
    Extent extent() const;
    QRectF area() const;
    QPointF at(double across, double y_mm) const;
    void draw_piece(QPainter& painter, std::size_t piece) const;
    void draw_scales(QPainter& painter) const;
    void draw_path();
    void fit();

    const Tokens* tokens_ = nullptr;
    program::DecodedPointer program_;
    Plane plane_ = Plane::r1;
    std::uint64_t line_ = 0;
    std::size_t marked_ = 0;
    Extent shown_;
    QPixmap drawn_;  ///< scales and path without the mark; null: to be drawn anew
};

}  // namespace psicarve::ui
