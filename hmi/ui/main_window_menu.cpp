// SPDX-License-Identifier: GPL-3.0-or-later
#include <QActionGroup>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>

#include <array>
#include <functional>
#include <utility>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/job_panel.hpp"
#include "hmi/ui/layers_page.hpp"
#include "hmi/ui/main_window.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/strip.hpp"

namespace psicarve::ui {

void MainWindow::make_menu() {
    QAction* open_action = menu_->addAction(tr("Open model, job or recording…"));
    open_action->setShortcut(QKeySequence::Open);
    connect(open_action, &QAction::triggered, this, [this] { choose_file(); });
    recent_ = menu_->addMenu(tr("Open recent"));
    connect(recent_, &QMenu::aboutToShow, this, [this] { fill_recent(); });
    menu_->addSeparator();
    make_theme_menu();
    make_language_menu();
    QAction* keys = menu_->addAction(tr("Keys…"));
    keys->setShortcut(Qt::Key_F12);
    connect(keys, &QAction::triggered, this, [this] {
        QMessageBox box{
            QMessageBox::Information, tr("Keys"),
            tr("F1  emergency stop, everywhere\nEsc  stop, everywhere, while the machine is at "
               "work\nCtrl+Enter  start\nPause  hold, resume\n"
               "Ctrl+Home  home all\nCtrl+0, Ctrl+−, Ctrl++  feed override\nCtrl+O  open\nF5  slice\nF9  arm "
               "keyboard jog\nCtrl+1 … 7  tabs\nCtrl+L  layer number\nF6  next pane\nF10  "
               "menu\nF12  this list\n\n"
               "Replay: K  play, pause\nJ, L  slower, faster\nN, Shift+N  next entry, entry before\n,  .  "
               "one layer\n"
               "On the timeline: arrows, Page Up, Page Down, Home, End"),
            QMessageBox::Ok, this};
        run_dialog(box);
    });
    menu_->addSeparator();
    QAction* quit = menu_->addAction(tr("Close the window"));
    quit->setShortcut(QKeySequence::Quit);
    connect(quit, &QAction::triggered, this, [this] { close(); });
    addActions({open_action, keys, quit});
    constexpr int kTabs = 7;
    for (int i = 0; i < kTabs; ++i) {
        auto* show = new QAction{this};
        show->setShortcut(QKeySequence{Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + i)});
        connect(show, &QAction::triggered, this, [this, i] { tabs_->setCurrentIndex(i); });
        addAction(show);
    }
    const std::pair<QKeySequence, std::function<void()>> places[] = {
        {QKeySequence{Qt::CTRL | Qt::Key_L},
         [this] {
             tabs_->setCurrentWidget(layers_);
             layers_->choose_number();
         }},
        {QKeySequence{Qt::Key_F6}, [this] { go_to_next_pane(); }},
    };
    for (const auto& [keys_of_place, go] : places) {
        auto* action = new QAction{this};
        action->setShortcut(keys_of_place);
        connect(action, &QAction::triggered, this, [go = go] { go(); });
        addAction(action);
    }
    auto* pause = new QAction{this};
    pause->setShortcut(Qt::Key_Pause);
    pause->setShortcutContext(Qt::ApplicationShortcut);  // from dialogs, too
    connect(pause, &QAction::triggered, this, [this] {
        const bool is_held = bench_.machine.sight().state() == MachineState::held;
        const CommandKind kind = is_held ? CommandKind::resume : CommandKind::hold;
        bench_.machine.order(kind, is_held ? session::phrase("Resume") : session::phrase("Hold"));
    });
    addAction(pause);
    const std::pair<QKeySequence, int> feeds[] = {
        {QKeySequence{Qt::CTRL | Qt::Key_0}, 0},
        {QKeySequence{Qt::CTRL | Qt::Key_Minus}, -5},
        {QKeySequence{Qt::CTRL | Qt::Key_Plus}, 5},
        {QKeySequence{Qt::CTRL | Qt::Key_Equal}, 5},
    };
    for (const auto& [keys_of_feed, percent] : feeds) {
        auto* change = new QAction{this};
        change->setShortcut(keys_of_feed);
        connect(change, &QAction::triggered, this, [this, by = percent] { job_->change_override(by); });
        addAction(change);
    }
    make_replay_keys();
}

/// Strip, left, middle, right; only what can take the focus.
void MainWindow::go_to_next_pane() {
    const std::array<QWidget*, 4> panes{strip_, &sides_->left(), tabs_, &sides_->right()};
    const QWidget* const focus = focusWidget();
    std::size_t here = 0;
    for (std::size_t i = 0; focus != nullptr && i < panes.size(); ++i) {
        if (panes[i]->isAncestorOf(focus)) here = i;
    }
    for (std::size_t step = 1; step <= panes.size(); ++step) {
        const QWidget* const pane = panes[(here + step) % panes.size()];
        for (QWidget* child : pane->findChildren<QWidget*>()) {
            if (!child->isVisible() || !child->isEnabled() || (child->focusPolicy() & Qt::TabFocus) == 0)
                continue;
            return child->setFocus(Qt::TabFocusReason);
        }
    }
}

void MainWindow::make_theme_menu() {
    QMenu* themes = menu_->addMenu(tr("Theme"));
    auto* group = new QActionGroup{this};
    const std::pair<QString, ThemeChoice> choices[] = {{tr("As the desktop"), ThemeChoice::system},
                                                       {tr("Light"), ThemeChoice::light},
                                                       {tr("Dark"), ThemeChoice::dark}};
    for (const auto& [name, choice] : choices) {
        QAction* action = themes->addAction(name);
        action->setCheckable(true);
        action->setChecked(choice == settings_.theme());
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, wanted = choice] { set_theme(wanted); });
    }
}

void MainWindow::make_language_menu() {
    QMenu* languages = menu_->addMenu(tr("Language"));
    languages->setObjectName("languages");
    auto* group = new QActionGroup{this};
    const auto add = [&](const QString& name, std::optional<Language> choice) {
        QAction* action = languages->addAction(name);
        action->setCheckable(true);
        action->setChecked(choice == settings_.language());
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, choice] {
            settings_.set_language(choice);
            bench_.log.add(session::Severity::info,
                           session::phrase("The language changes when the window is opened the next time"));
        });
    };
    add(tr("As the desktop"), std::nullopt);
    for (const LanguageName& name : kLanguages) add(QString::fromUtf8(name.own), name.language);
}

void MainWindow::choose_file() {
    const QString path = ask_for_file(
        this, tr("Open model, job or recording"), settings_.last_folder(),
        tr("Models and jobs (*.stl *.obj *.ply *.3mf *.off *.job *.psi);;Recordings (*.snap *.trace);;"
           "All files (*)"));
    if (!path.isEmpty()) open(path);
}

void MainWindow::fill_recent() {
    recent_->clear();
    const QStringList files = settings_.recent_files();
    for (const QString& path : files) {
        QAction* action = recent_->addAction(QFileInfo{path}.fileName());
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { open(path); });
    }
    if (files.isEmpty()) recent_->addAction(tr("None yet"))->setEnabled(false);
}

CloseChoice MainWindow::ask_what_to_do() {
    QMessageBox box{QMessageBox::Question, tr("Close the window"),
                    tr("The machine is at work. It does not need this window: what is to become of it?"),
                    QMessageBox::NoButton, this};
    QPushButton* leave = box.addButton(tr("Leave running"), QMessageBox::AcceptRole);
    QPushButton* hold = box.addButton(tr("Hold"), QMessageBox::ActionRole);
    QPushButton* stop = box.addButton(tr("Stop"), QMessageBox::ActionRole);
    box.addButton(tr("Cancel"), QMessageBox::RejectRole);
    hold->setEnabled(bench_.machine.sight().state() == MachineState::carving);
    box.setDefaultButton(leave);
    run_dialog(box);
    if (box.clickedButton() == leave) return CloseChoice::leave_running;
    if (box.clickedButton() == hold) return CloseChoice::hold;
    return box.clickedButton() == stop ? CloseChoice::stop : CloseChoice::stay_open;
}

}  // namespace psicarve::ui
