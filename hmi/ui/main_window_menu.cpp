// SPDX-License-Identifier: GPL-3.0-or-later
#include <QActionGroup>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/job_panel.hpp"
#include "hmi/ui/main_window.hpp"

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
            tr("F1  emergency stop, everywhere\nCtrl+Enter  start\nPause  hold, resume\n"
               "Ctrl+Home  home all\nCtrl+0, Ctrl+−, Ctrl++  feed override\nCtrl+O  open\nF5  slice\nF9  arm "
               "keyboard jog\nCtrl+1 … 7  tabs\nF10  "
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
    auto* pause = new QAction{this};
    pause->setShortcut(Qt::Key_Pause);
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
