// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <optional>
#include <vector>

#include "hmi/profile/pin_rows.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;
class QTableWidget;

namespace psicarve::ui {

class ConnectorView;
class TimingView;
class ActionButton;
class WiringBar;

/// The connector with live levels, and every signal's last seconds. Levels are logical.
class PortsPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PortsPage)
public:
    explicit PortsPage(WindowContext& context, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// Has the core record into this file; what the button does once a file was chosen.
    void record_to(const QString& path);
    /// Ends the wiring test.
    void let_go();

private:
    void take_profile(const Profile& profile);
    void fill_table();
    void fit_rows();
    void fit_columns();
    void show_levels(SignalWord levels);
    void note_live_levels();
    void make_record_button();
    void change_recording();
    void refresh_record_button();
    void show_recording();

    WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    std::optional<Profile> profile_;
    std::vector<session::PinRow> rows_;
    std::optional<SignalWord> shown_levels_;
    std::uint32_t core_pid_ = 0;
    int row_height_px_ = 0;
    ConnectorView* connector_;
    QTableWidget* table_;
    TimingView* timing_;
    QLabel* note_;
    ActionButton* record_ = nullptr;
    WiringBar* wiring_;
};

}  // namespace psicarve::ui
