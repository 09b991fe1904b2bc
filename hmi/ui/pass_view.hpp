// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "hmi/session/pass_sketch.hpp"
#include "hmi/ui/tokens.hpp"

class QPainter;

namespace psicarve::ui {

/// The blank from its axis outwards, what the passes leave of it, and the left head's tool, all to one scale.
class PassView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PassView)
public:
    /// Of the form, which is as wide as the longest word in a choice needs beside a scroll bar.
    static constexpr int kWidth_px = 242;
    static constexpr double kRatio = 0.5;  ///< heights a width

    explicit PassView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_sketch(session::PassSketch sketch);
    const session::PassSketch& sketch() const noexcept { return sketch_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QPointF place(const session::SketchPoint& point) const;
    QPolygonF polygon(const std::vector<session::SketchPoint>& points) const;
    void draw_blank(QPainter& painter) const;
    void draw_depths(QPainter& painter) const;
    void draw_tool(QPainter& painter) const;
    void draw_words(QPainter& painter) const;

    const Tokens* tokens_ = nullptr;
    session::PassSketch sketch_;
};

}  // namespace psicarve::ui
