// SPDX-License-Identifier: GPL-3.0-or-later
#include <QActionGroup>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <array>
#include <chrono>
#include <functional>
#include <utility>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/file_filters.hpp"
#include "hmi/ui/job_panel.hpp"
#include "hmi/ui/keys_dialog.hpp"
#include "hmi/ui/layers_page.hpp"
#include "hmi/ui/main_window.hpp"
#include "hmi/ui/page_tabs.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/strip.hpp"

namespace psicarve::ui {
namespace {

constexpr std::chrono::milliseconds kLookPause{50};

}  // namespace

void MainWindow::make_menu() {
    file_menu_ = menu_->addMenu(tr("File"));
    machine_menu_ = menu_->addMenu(tr("Machine"));
    view_menu_ = menu_->addMenu(tr("View"));
    tools_menu_ = menu_->addMenu(tr("Tools"));
    help_menu_ = menu_->addMenu(tr("Help"));
    menuBar()->setObjectName("menu_bar");
    for (QMenu* menu : {file_menu_, machine_menu_, view_menu_, tools_menu_, help_menu_})
        menuBar()->addMenu(menu);
    menuBar()->hide();
    make_file_menu();
    make_theme_menu();
    make_language_menu();
    make_machine_menu();
    make_tools_menu();
    make_help_menu();
    make_places();
    make_job_keys();
    make_replay_keys();
}

/// The same menus, in a bar where there is room for it, else behind the strip's button.
void MainWindow::show_menu_bar(bool is_shown) {
    menuBar()->setVisible(is_shown);
}

void MainWindow::make_file_menu() {
    QAction* open_action = file_menu_->addAction(tr("Open model, job, program or recording…"));
    open_action->setObjectName("open_action");
    open_action->setShortcut(QKeySequence::Open);
    connect(open_action, &QAction::triggered, this, [this] { choose_file(); });
    recent_ = file_menu_->addMenu(tr("Open recent"));
    recent_->setObjectName("recent_menu");
    connect(recent_, &QMenu::aboutToShow, this, [this] { fill_recent(); });
    look_for_recent();
    file_menu_->addSeparator();
    make_keeping_actions();
    file_menu_->addSeparator();
    QAction* quit = file_menu_->addAction(tr("Close the window"));
    quit->setObjectName("close_action");
    quit->setShortcut(Qt::CTRL | Qt::Key_Q);  // desktops that Qt does not know have no key for it
    connect(quit, &QAction::triggered, this, [this] { close(); });
    addActions({open_action, quit});
}

void MainWindow::make_help_menu() {
    QAction* keys = help_menu_->addAction(tr("Keys…"));
    keys->setObjectName("keys_action");
    keys->setShortcut(Qt::Key_F12);
    connect(keys, &QAction::triggered, this, [this] {
        KeysDialog list{this};
        run_dialog(list);
    });
    QAction* about = help_menu_->addAction(tr("About Psicarve…"));
    about->setObjectName("about_action");
    connect(about, &QAction::triggered, this, [this] {
        QMessageBox box{
            QMessageBox::Information, tr("About Psicarve"),
            QStringLiteral("Psicarve " PSICARVE_VERSION "\nQt %1\nGPL-3.0-or-later").arg(qVersion()),
            QMessageBox::Ok, this};
        box.setObjectName("about");
        box.button(QMessageBox::Ok)->setObjectName("about_ok");
        run_dialog(box);
    });
    addAction(keys);
}

void MainWindow::make_places() {
    constexpr int kTabs = 8;
    for (int i = 0; i < kTabs; ++i) {
        auto* show = new QAction{this};
        show->setObjectName(QStringLiteral("page_%1_key").arg(i + 1));
        show->setShortcut(QKeySequence{Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + i)});
        connect(show, &QAction::triggered, this, [this, i] { pages_->setCurrentIndex(i); });
        addAction(show);
    }
    struct Place {
        const char* name;
        QKeySequence keys;
        std::function<void()> go;
    };
    const Place places[] = {
        {"layer_number_key", QKeySequence{Qt::CTRL | Qt::Key_L},
         [this] {
             pages_->show_page(pages_->layers());
             pages_->layers().choose_number();
         }},
        {"next_pane_key", QKeySequence{Qt::Key_F6}, [this] { go_to_next_pane(); }},
        {"menu_key", QKeySequence{Qt::Key_F10},
         [this] {
             if (menuBar()->isVisible()) menuBar()->setActiveAction(menuBar()->actions().front());
             if (!menuBar()->isVisible()) strip_->open_menu();
         }},
    };
    for (const Place& place : places) {
        auto* action = new QAction{this};
        action->setObjectName(place.name);
        action->setShortcut(place.keys);
        connect(action, &QAction::triggered, this, [go = place.go] { go(); });
        addAction(action);
    }
}

void MainWindow::make_job_keys() {
    auto* pause = new QAction{this};
    pause->setObjectName("pause_key");
    pause->setShortcut(Qt::Key_Pause);
    pause->setShortcutContext(Qt::ApplicationShortcut);  // from dialogs, too
    connect(pause, &QAction::triggered, this, [this] {
        const bool is_held = context_.machine.view().state() == MachineState::held;
        const CommandKind kind = is_held ? CommandKind::resume : CommandKind::hold;
        context_.machine.order(kind, is_held ? session::phrase("Resume") : session::phrase("Hold"));
    });
    addAction(pause);
    struct Feed {
        const char* name;
        QList<QKeySequence> keys;
        int by_percent;
    };
    const Feed feeds[] = {
        {"feed_full_key", {QKeySequence{Qt::CTRL | Qt::Key_0}}, 0},
        {"feed_less_key", {QKeySequence{Qt::CTRL | Qt::Key_Minus}}, -5},
        {"feed_more_key", {QKeySequence{Qt::CTRL | Qt::Key_Plus}, QKeySequence{Qt::CTRL | Qt::Key_Equal}}, 5},
    };
    for (const Feed& feed : feeds) {
        auto* change = new QAction{this};
        change->setObjectName(feed.name);
        change->setShortcuts(feed.keys);
        connect(change, &QAction::triggered, this,
                [this, by = feed.by_percent] { job_->change_override(by); });
        addAction(change);
    }
}

/// Strip, left, middle, right; only what can take the focus.
void MainWindow::go_to_next_pane() {
    const std::array<QWidget*, 4> panes{strip_, &sides_->left(), pages_, &sides_->right()};
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
    QMenu* themes = view_menu_->addMenu(tr("Theme"));
    auto* group = new QActionGroup{this};
    struct Choice {
        const char* id;
        QString name;
        ThemeChoice choice;
    };
    const Choice choices[] = {{"theme_system", tr("As the desktop"), ThemeChoice::system},
                              {"theme_light", tr("Light"), ThemeChoice::light},
                              {"theme_dark", tr("Dark"), ThemeChoice::dark}};
    for (const auto& [id, name, choice] : choices) {
        QAction* action = themes->addAction(name);
        action->setObjectName(id);
        action->setCheckable(true);
        action->setChecked(choice == settings_.theme());
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, wanted = choice] { set_theme(wanted); });
        connect(themes, &QMenu::aboutToShow, action,
                [this, action, own = choice] { action->setChecked(own == settings_.theme()); });
    }
}

void MainWindow::make_language_menu() {
    QMenu* languages = view_menu_->addMenu(tr("Language"));
    languages->setObjectName("languages");
    auto* group = new QActionGroup{this};
    const auto add = [&](const QString& id, const QString& name, std::optional<Language> choice) {
        QAction* action = languages->addAction(name);
        action->setObjectName("language_" + id);
        action->setCheckable(true);
        action->setChecked(choice == settings_.language());
        group->addAction(action);
        connect(languages, &QMenu::aboutToShow, action,
                [this, action, choice] { action->setChecked(choice == settings_.language()); });
        connect(action, &QAction::triggered, this, [this, choice] { choose_language(choice); });
    };
    add("system", tr("As the desktop"), std::nullopt);
    for (const LanguageName& name : kLanguages)
        add(QLatin1String(name.code), QString::fromUtf8(name.own), name.language);
}

void MainWindow::choose_file() {
    const QString path =
        ask_for_file(this, tr("Open model, job, program or recording"), last_folder(), filters_of_files());
    if (!path.isEmpty()) open(path);
}

void MainWindow::look_for_recent() {
    context_.presence.look_above(settings_.last_folder().toStdString());
    std::vector<std::string> files;
    for (const QString& path : settings_.recent_files()) files.push_back(path.toStdString());
    context_.presence.look(std::move(files));
}

void MainWindow::fill_recent() {
    recent_->clear();
    const QStringList files = settings_.recent_files();
    for (const QString& path : files) {
        if (context_.presence.seen(path.toStdString()).state == session::FilePresence::State::gone) continue;
        QAction* action = recent_->addAction(QFileInfo{path}.fileName());
        action->setObjectName("recent_file");
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { open(path); });
    }
    if (recent_->isEmpty()) recent_->addAction(tr("None yet"))->setEnabled(false);
    look_for_recent();  // for the next time
}

CloseChoice MainWindow::ask_what_to_do() {
    QMessageBox box{QMessageBox::Question, tr("Close the window"),
                    tr("The machine is at work. It does not need this window: what is to become of it?"),
                    QMessageBox::NoButton, this};
    QPushButton* leave = box.addButton(tr("Leave running"), QMessageBox::AcceptRole);
    QPushButton* hold = box.addButton(tr("Hold"), QMessageBox::ActionRole);
    QPushButton* stop = box.addButton(tr("Stop"), QMessageBox::ActionRole);
    QPushButton* stay = box.addButton(tr("Cancel"), QMessageBox::RejectRole);
    leave->setObjectName("close_leave_running");
    hold->setObjectName("close_hold");
    stop->setObjectName("close_stop");
    stay->setObjectName("close_cancel");
    box.setEscapeButton(stay);
    box.setObjectName("close_question");
    box.setDefaultButton(leave);
    // What it asks about may end while it is asked: by a stop, by the last layer.
    const auto keep_true = [this, &box, hold] {
        hold->setEnabled(context_.machine.view().state() == MachineState::carving);
        if (is_under_way()) return;
        context_.log.add(session::Severity::info,
                         session::phrase("The machine is at work no more: the window can be closed"));
        box.reject();
    };
    QTimer look;
    connect(&look, &QTimer::timeout, &box, keep_true);
    look.start(kLookPause);
    hold->setEnabled(context_.machine.view().state() == MachineState::carving);
    run_dialog(box);
    if (box.clickedButton() == leave) return CloseChoice::leave_running;
    if (box.clickedButton() == hold) return CloseChoice::hold;
    return box.clickedButton() == stop ? CloseChoice::stop : CloseChoice::stay_open;
}

}  // namespace psicarve::ui
