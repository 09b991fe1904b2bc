// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QFileInfo>
#include <QMenu>

#include <functional>

#include "hmi/ui/carving_page.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/main_window.hpp"
#include "hmi/ui/model_page.hpp"
#include "hmi/ui/page_tabs.hpp"
#include "hmi/ui/replay_bar.hpp"

namespace psicarve::ui {

void MainWindow::make_replay_keys() {
    replay::ReplaySession& replay = context_.replay;
    struct Act {
        const char* name;
        QKeySequence key;
        std::function<void()> act;
    };
    const Act keys[] = {
        {"replay_play_key", Qt::Key_K, [this] { replay_->play_or_pause(); }},
        {"replay_slower_key", Qt::Key_J, [&replay] { replay.clock().slower(); }},
        {"replay_faster_key", Qt::Key_L, [&replay] { replay.clock().faster(); }},
        {"replay_next_key", Qt::Key_N, [this] { replay_->go_to_next_entry(); }},
        {"replay_before_key", Qt::SHIFT | Qt::Key_N, [this] { replay_->go_to_entry_before(); }},
        {"layer_before_key", Qt::Key_Comma, [&replay] { replay.step_layer(-1); }},
        {"next_layer_key", Qt::Key_Period, [&replay] { replay.step_layer(1); }}};
    for (const auto& [name, key, act] : keys) {
        auto* action = new QAction{this};
        action->setObjectName(name);
        action->setShortcut(key);
        action->setEnabled(false);
        connect(action, &QAction::triggered, this, [wanted = act] { wanted(); });
        addAction(action);
        replay_actions_.push_back(action);
    }
    QAction* leave = file_menu_->addAction(tr("Leave replay"));
    leave->setObjectName("leave_replay");
    leave->setEnabled(false);
    connect(leave, &QAction::triggered, this, [&replay] { replay.leave(); });
    replay_actions_.push_back(leave);
}

void MainWindow::choose_job_of_trace() {
    const QString path = ask_for_file(this, tr("Job or snapshot of this trace"), last_folder(),
                                      tr("Jobs and snapshots (*.job *.psi *.snap);;All files (*)"));
    if (!path.isEmpty()) context_.replay.add_job(path.toStdString());
}

void MainWindow::refresh_replay() {
    replay_->refresh();
    pages_->refresh_entries();
    if (shown_replay_ == context_.replay.edition()) return;
    shown_replay_ = context_.replay.edition();
    const bool is_open = context_.replay.is_open();
    // Whatever a hand holds is let go: from here on it would be on something that is not the machine.
    let_go();
    for (QAction* action : replay_actions_) action->setEnabled(is_open);
    pages_->show_entries(is_open);
    // The model is not in a recording.
    if (is_open && pages_->is_current(pages_->model())) pages_->show_page(pages_->carving());
}

/// "figurine.stl – Psicarve"
void MainWindow::refresh_title() {
    const bool is_replay = context_.replay.is_open();
    const std::string path = is_replay ? context_.replay.facts().path : context_.open_job.path();
    const QString name = QFileInfo{QString::fromStdString(path)}.fileName();
    const QString shown = is_replay ? tr("REPLAY: %1").arg(name) : name;
    const QString title = shown.isEmpty() ? QStringLiteral("Psicarve") : shown + " \u2013 Psicarve";
    if (windowTitle() != title) setWindowTitle(title);
}

}  // namespace psicarve::ui
