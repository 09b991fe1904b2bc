// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QBoxLayout;
class QHBoxLayout;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace psicarve::ui {

class StatePill;

/// The fixed top of the window: menu, state, heartbeat, what machine it is, progress, emergency stop. Its
/// members: widgets.
class Strip : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::Strip)
public:
    Strip(WindowContext& context, QMenu* menu, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    void set_room(Room room);
    void open_menu();
    /// Acts at once, whatever the machine does; also when no core is there to hear it.
    void emergency_stop();
    QPushButton& emergency_button() noexcept { return *emergency_; }

private:
    void refresh_pill();
    void refresh_heartbeat();
    void refresh_badge();
    void refresh_replay();
    void refresh_progress();
    QString time_words() const;
    void show_time(const QString& text);

    WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    QToolButton* menu_button_;
    StatePill* pill_;
    QLabel* heart_;
    QLabel* tick_;
    QLabel* missed_;
    QLabel* badge_;
    QLabel* percent_;
    QLabel* work_;  ///< where there is room
    QLabel* time_;
    QBoxLayout* pulse_ = nullptr;   ///< heartbeat and badge
    QHBoxLayout* above_ = nullptr;  ///< what stands over the progress
    bool is_short_ = false;
    QProgressBar* progress_;
    QPushButton* emergency_;
    QLabel* emergency_icon_;
    QLabel* emergency_second_;
};

}  // namespace psicarve::ui
