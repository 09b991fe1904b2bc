// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "hmi/session/latency_trial.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QComboBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace psicarve::ui {

class HistogramView;

/// Measures this computer at length, with the core's tick loop and nothing in the tick.
class LatencyPanel : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::LatencyPanel)
public:
    explicit LatencyPanel(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// How many ticks were how many microseconds late.
    void save(const QString& path);

private:
    QLayout* make_wish();
    machine::LatencyOptions options() const;
    void show_result();

    WindowContext& context_;
    QSpinBox* seconds_;
    QSpinBox* period_;
    QComboBox* cpu_;
    ActionButton* begin_;
    QPushButton* end_;
    QPushButton* save_;
    QProgressBar* progress_;
    QLabel* said_;
    HistogramView* histogram_;
    QGridLayout* rows_;
};

}  // namespace psicarve::ui
