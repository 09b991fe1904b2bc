// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QMainWindow>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "hmi/session/profile_arrival.hpp"
#include "hmi/session/status_line.hpp"
#include "hmi/ui/settings.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/space_canvas.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;
class QMenu;
class QAction;

namespace psicarve::ui {

class AlarmBanner;
class CompareTool;
class FirstTouch;
class JobPanel;
class JogPanel;
class OptionKeeper;
class PageTabs;
class PlaceKeeper;
class PositionPanel;
class RefusalBar;
class UnfinishedBar;
class CoreProfileBar;
class ReplayBar;
class Strip;

/// What is to become of a machine that moves when the window closes.
enum class CloseChoice : std::uint8_t { stay_open, leave_running, hold, stop };

/// The operator's window. Looks at the machine at screen rate and never waits for it. Its members: the window
/// context, menus, panels, bars and pages that it puts together, and what keeps settings and keys; what each
/// does stands in its own header.
class MainWindow : public QMainWindow {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MainWindow)
public:
    /// Between two looks at the machine.
    static constexpr std::chrono::milliseconds kLookPause{33};

    /// Null settings: the user's own.
    explicit MainWindow(const session::SessionOptions& options, Drawing drawing = Drawing::painter,
                        std::unique_ptr<SettingsStore> settings = nullptr);
    ~MainWindow() override;

    WindowContext& context() noexcept { return context_; }
    void open(const QString& path);
    /// What the command line names, either may be empty: the machine's profile, then what is to be opened. At
    /// once, and with neither on the page that was open the last time.
    void begin_with(const QString& profile, const QString& path);
    /// One look at the machine, and everything redrawn that has changed. The timer calls it.
    void refresh();
    void set_theme(ThemeChoice choice);
    void emergency_stop();
    /// In order, at once; the machine has something to stop.
    void stop();
    bool may_stop() const;
    /// What Esc does now outside dialogs and menus; empty: nothing.
    std::function<void()> escape_act();
    /// The page that was open the last time.
    void go_to_last_page();
    /// For a program that ends: nothing is asked, the machine's job is left alone, and what a hand holds is
    /// let go.
    void leave();
    /// Whatever a hand holds.
    void let_go();
    /// For tests, instead of the dialog.
    void set_close_question(std::function<CloseChoice()> ask) { ask_ = std::move(ask); }

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    class StopKeys;

    enum class Begin : std::uint8_t { anew, with_work_that_comes };
    void build(Begin begin);
    void take_down();
    void show_room(Room room);
    // main_window_language.cpp
    void choose_language(std::optional<Language> choice);
    bool may_change_language() const;
    void change_language();
    void make_menu();
    void make_file_menu();
    void make_help_menu();
    void make_keeping_actions();
    void make_machine_menu();
    void make_tools_menu();
    void make_panels_menu();
    void float_panel(std::size_t panel, bool floats);
    void keep_panel_places();
    void show_kept_panels();
    void take_place();
    void keep_place();
    void write_place();
    void show_kept_place();
    void show_last_message();
    void close_once_held();
    void refresh_tools();
    void choose_trace_to_verify();
    void verify_replay();
    void save_as(const QString& title, const QString& name, const QString& filter,
                 const std::function<void(const std::string&)>& save);
    void make_places();
    void make_job_keys();
    void show_menu_bar(bool is_shown);
    void go_to_next_pane();
    void make_theme_menu();
    void show_theme();
    void take_settings();
    void take_profile(const Result<Profile>& read, const QString& profile, const QString& path);
    QString last_folder();
    void make_language_menu();
    void make_replay_keys();
    void choose_job_of_trace();
    void refresh_replay();
    QWidget* make_centre();
    void make_status_bar();
    void choose_file();
    void look_for_recent();
    void fill_recent();
    void refresh_status_bar();
    void elide_message();
    void refresh_profile_label();
    void refresh_title();
    bool is_under_way() const;
    CloseChoice ask_what_to_do();

    WindowContext context_;
    Drawing drawing_;
    WindowSettings settings_;
    Theme theme_ = Theme::light;  ///< that is shown
    bool wants_last_page_ = false;
    session::ProfileArrival arrival_;
    QMenu* menu_ = nullptr;
    CompareTool* compare_ = nullptr;
    QMenu* file_menu_ = nullptr;
    QMenu* machine_menu_ = nullptr;
    QMenu* view_menu_ = nullptr;
    QMenu* tools_menu_ = nullptr;
    QMenu* help_menu_ = nullptr;
    QMenu* recent_ = nullptr;
    Strip* strip_ = nullptr;
    PositionPanel* position_ = nullptr;
    JogPanel* jog_ = nullptr;
    JobPanel* job_ = nullptr;
    std::unique_ptr<SidePanels> sides_;
    AlarmBanner* banner_ = nullptr;
    RefusalBar* refusal_ = nullptr;
    UnfinishedBar* unfinished_ = nullptr;
    CoreProfileBar* core_profile_ = nullptr;
    PageTabs* pages_ = nullptr;
    ReplayBar* replay_ = nullptr;
    std::vector<QAction*> float_actions_;
    QAction* save_job_ = nullptr;
    QAction* save_tables_ = nullptr;
    QAction* verify_ = nullptr;
    std::vector<QAction*> replay_actions_;  ///< only while a recording is shown
    std::uint64_t shown_replay_ = 0;
    QWidget* status_row_ = nullptr;
    QLabel* last_message_ = nullptr;
    QString message_text_;  ///< in full
    QLabel* profile_label_ = nullptr;
    QLabel* language_label_ = nullptr;
    session::StatusLine status_line_;
    std::function<CloseChoice()> ask_;
    std::unique_ptr<StopKeys> stop_keys_;
    std::unique_ptr<FirstTouch> first_touch_;  ///< until settings that came late are taken
    std::unique_ptr<PlaceKeeper> place_keeper_;
    std::unique_ptr<OptionKeeper> option_keeper_;
    bool closes_held_ = false;  ///< the core has taken the hold that was to be closed with
    QTimer timer_;
    QTimer language_timer_;  ///< runs while another language is wanted
};

}  // namespace psicarve::ui
