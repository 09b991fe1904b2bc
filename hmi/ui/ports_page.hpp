// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <optional>
#include <vector>

#include "hmi/session/level_history.hpp"
#include "hmi/session/pin_rows.hpp"
#include "hmi/ui/bench.hpp"
#include "hmi/ui/tokens.hpp"

class QLabel;
class QTableWidget;

namespace psicarve::ui {

class ConnectorView;
class TimingView;
class WiringBar;

/// The connector with live levels, and every signal's last seconds. Levels are logical.
class PortsPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PortsPage)
public:
    explicit PortsPage(Bench& bench, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// Ends the wiring test.
    void let_go();

private:
    void take_profile(const Profile& profile);
    void fill_table();
    void fit_rows();
    void show_levels(SignalWord levels);
    void note_live_levels();
    void show_recording();

    Bench& bench_;
    const Tokens* tokens_ = nullptr;
    std::optional<Profile> profile_;
    std::vector<session::PinRow> rows_;
    std::optional<SignalWord> shown_levels_;
    session::LevelHistory history_;
    std::uint32_t core_pid_ = 0;
    int row_height_px_ = 0;
    ConnectorView* connector_;
    QTableWidget* table_;
    TimingView* timing_;
    QLabel* note_;
    WiringBar* wiring_;
};

}  // namespace psicarve::ui
