// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

#include "hmi/session/level_history.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// The pins' last seconds: a line a signal, in rows that fit the table beside it. Steps are drawn as a band
/// whose height goes with their rate, since a screen cannot show thousands a second.
class TimingView : public QWidget {
public:
    explicit TimingView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void set_rows(std::vector<Signal> signals_of_rows, int first_row_px, int row_height_px);
    void show_history(const session::LevelHistory& history, session::LevelHistory::Clock::time_point now);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void draw_levels(QPainter& painter, Signal signal, const QRectF& row) const;
    void draw_steps(QPainter& painter, Axis axis, const QRectF& row) const;
    double x_of(session::LevelHistory::Clock::time_point time) const;
    QColor colour_of(Signal signal) const;

    const Tokens* tokens_ = nullptr;
    const session::LevelHistory* history_ = nullptr;
    session::LevelHistory::Clock::time_point now_;
    std::vector<Signal> rows_;
    int first_row_px_ = 0;
    int row_height_px_ = 24;
};

}  // namespace psicarve::ui
