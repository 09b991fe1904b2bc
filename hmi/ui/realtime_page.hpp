// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <utility>
#include <vector>

#include "hmi/session/background_queue.hpp"
#include "hmi/session/computer_rows.hpp"
#include "hmi/session/tick_health.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QBoxLayout;
class QGridLayout;
class QLabel;
class QLayout;
class QPushButton;

namespace psicarve::ui {

class ComputerTable;
class HistogramView;
class LatencyPanel;

/// How punctual the core is: the histogram of its ticks' lateness, what was missed, and rates. Its members:
/// widgets, a label for each figure.
class RealtimePage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::RealtimePage)
public:
    explicit RealtimePage(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// Looks at this computer anew, and shows what was found.
    void check_computer();
    /// It does not look at the computer just now.
    bool is_quiet() const { return queue_.is_idle(); }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class Shown : std::uint8_t { core_steps, computer, measurement };
    QLayout* make_choice();
    void arrange_facts();
    void show(Shown what);
    void show_lateness(const CoreStatus& status, const session::TickHealth& health);
    void refresh_table(const CoreStatus* status);

    WindowContext& context_;
    QGridLayout* facts_;
    QBoxLayout* choice_ = nullptr;
    std::vector<std::pair<QLabel*, QLabel*>> pairs_;  ///< title and value, as they are read
    bool is_narrow_ = false;
    Shown shown_ = Shown::core_steps;
    QPushButton* steps_button_ = nullptr;
    QPushButton* computer_button_ = nullptr;
    QLabel* table_note_ = nullptr;
    ComputerTable* table_;
    std::vector<session::ComputerRow> findings_;
    session::RateMeter rates_;
    std::uint32_t core_pid_ = 0;
    HistogramView* histogram_;
    LatencyPanel* latency_;
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
    QLabel* faults_ = nullptr;
    session::BackgroundQueue queue_;  ///< last: its thread uses the others
};

}  // namespace psicarve::ui
