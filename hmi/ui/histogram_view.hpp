// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

#include "hmi/session/tick_health.hpp"
#include "hmi/ui/tokens.hpp"

class QCPBars;
class QCPItemStraightLine;
class QCPItemText;
class QCustomPlot;

namespace psicarve::ui {

/// The lateness of all ticks, a bar for each doubling; bars at which a tick may have been missed are red.
class HistogramView : public QWidget {
public:
    explicit HistogramView(QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void show_health(const session::TickHealth& health);

private:
    void colour();
    void draw();
    void draw_bars(std::size_t first);
    void draw_period(std::size_t first);
    QCPItemText* text_item();

    const Tokens* tokens_ = nullptr;
    session::TickHealth health_;
    QCustomPlot* plot_;
    QCPBars* in_time_;
    QCPBars* too_late_;
    QCPItemStraightLine* period_;
    QCPItemText* period_text_;
    QCPItemText* nothing_;
    std::vector<QCPItemText*> counts_;
};

}  // namespace psicarve::ui
