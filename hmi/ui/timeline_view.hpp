// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <cstdint>
#include <functional>

#include "hmi/replay/replay_session.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// A recording from its begin to its end: how busy the motors were, what happened, and the moment that is
/// shown, which is drawn about with mouse or keys.
class TimelineView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::TimelineView)
public:
    explicit TimelineView(replay::ReplaySession& replay, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// For tests: where on the widget a time is.
    int x_of(std::int64_t time_ns) const;
    /// What stands at a place, as the tooltip says it; empty: nothing.
    QString words_at(int x) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    std::int64_t time_of(int x) const;
    void paint_axis(QPainter& painter) const;
    void paint_activity(QPainter& painter) const;
    void paint_marks(QPainter& painter) const;
    void paint_cursor(QPainter& painter) const;

    replay::ReplaySession& replay_;
    const Tokens* tokens_ = nullptr;
    std::int64_t drawn_ns_ = -1;
    std::uint64_t drawn_edition_ = 0;
};

}  // namespace psicarve::ui
