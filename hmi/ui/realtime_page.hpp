// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "hmi/session/tick_health.hpp"
#include "hmi/ui/bench.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;

namespace psicarve::ui {

class HistogramView;

/// How punctual the core is: the histogram of its ticks' lateness, what was missed, and rates.
class RealtimePage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::RealtimePage)
public:
    explicit RealtimePage(Bench& bench, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();

private:
    Bench& bench_;
    session::RateMeter rates_;
    std::uint32_t core_pid_ = 0;
    HistogramView* histogram_;
    QLabel* verdict_;
    QLabel* rights_ = nullptr;
    QLabel* period_ = nullptr;
    QLabel* ticks_ = nullptr;
    QLabel* missed_ = nullptr;
    QLabel* percentiles_ = nullptr;
    QLabel* greatest_ = nullptr;
    QLabel* rate_ = nullptr;
    QLabel* pulses_ = nullptr;
    QLabel* waited_ = nullptr;
};

}  // namespace psicarve::ui
