// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <array>
#include <cstdint>

#include "hmi/session/tick_health.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;

namespace psicarve::ui {

/// What the axes do: pulses since the job was started, speed, how much of the axis' top speed that is, and
/// the pulses that are left by the tables.
class AxisTable : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::AxisTable)
public:
    explicit AxisTable(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// "feed 20.0 mm/s": of the faster head's tool over the surface; nothing when that is not known.
    QString feed_text() const;

private:
    struct Row {
        QLabel* name;
        QLabel* pulses;
        QLabel* speed;
        QLabel* share;
        QLabel* left;
    };
    void show_speed(Axis axis);
    void show_pulses_to_go();

    WindowContext& context_;
    std::array<Row, kAxisCount> rows_{};
    session::RateMeter rates_;
    std::uint32_t core_pid_ = 0;
};

}  // namespace psicarve::ui
