// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QMenu>

#include <utility>

#include "hmi/ui/compare_tool.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/jog_panel.hpp"
#include "hmi/ui/main_window.hpp"
#include "hmi/ui/page_tabs.hpp"
#include "hmi/ui/place_keeper.hpp"
#include "hmi/ui/ports_page.hpp"
#include "hmi/ui/profile_page.hpp"
#include "hmi/ui/program_page.hpp"
#include "hmi/ui/realtime_page.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/verdict_dialog.hpp"

namespace psicarve::ui {

void MainWindow::save_as(const QString& title, const QString& name, const QString& filter,
                         const std::function<void(const std::string&)>& save) {
    const QString path = ask_where_to_save(this, title, last_folder() + "/" + name, filter);
    if (!path.isEmpty()) save(path.toStdString());
}

void MainWindow::make_keeping_actions() {
    save_job_ = file_menu_->addAction(tr("Save the job…"));
    save_job_->setObjectName("save_job");
    connect(save_job_, &QAction::triggered, this, [this] {
        save_as(tr("Save the job"), "job.psi", tr("Jobs (*.job *.psi)"), [this](const std::string& path) {
            if (context_.open_job.job()) context_.files.save_job(path, context_.open_job.job());
        });
    });
    save_tables_ = file_menu_->addAction(tr("Save its tables…"));
    save_tables_->setObjectName("save_tables");
    connect(save_tables_, &QAction::triggered, this, [this] {
        save_as(tr("Save the tables"), "job.csv", tr("Tables (*.csv *.json)"),
                [this](const std::string& path) {
                    if (context_.open_job.job()) context_.files.save_tables(path, context_.open_job.job());
                });
    });
    QAction* snapshot = file_menu_->addAction(tr("Save a snapshot…"));
    snapshot->setObjectName("save_snapshot");
    snapshot->setToolTip(tr("Job, state and flight recorder of the machine, to be looked at later"));
    connect(snapshot, &QAction::triggered, this, [this] {
        save_as(tr("Save a snapshot"), "run.snap", tr("Snapshots (*.snap)"),
                [this](const std::string& path) { context_.files.save_snapshot(path); });
    });
}

void MainWindow::make_machine_menu() {
    QAction* go_to = machine_menu_->addAction(tr("Go to…"));
    go_to->setObjectName("go_to_action");
    connect(go_to, &QAction::triggered, this, [this] { jog_->go_to(); });
    QAction* spindle = machine_menu_->addAction(tr("Spindle on or off"));
    spindle->setObjectName("spindle_action");
    connect(spindle, &QAction::triggered, this, [this] { jog_->turn_spindle(); });
    QAction* program = machine_menu_->addAction(tr("Run a program in G-code…"));
    program->setObjectName("program_action");
    connect(program, &QAction::triggered, this, [this] {
        pages_->show_page(pages_->program());
        if (context_.program.path().empty()) pages_->program().choose_file();
    });
    QAction* wiring = machine_menu_->addAction(tr("Wiring test, recording pins…"));
    wiring->setObjectName("wiring_action");
    connect(wiring, &QAction::triggered, this, [this] { pages_->show_page(pages_->ports()); });
}

void MainWindow::make_tools_menu() {
    verify_ = tools_menu_->addAction(QString{});
    verify_->setObjectName("verify_action");
    connect(verify_, &QAction::triggered, this, [this] {
        if (context_.judge.is_judging()) return context_.judge.cancel();
        choose_trace_to_verify();
    });
    compare_ = new CompareTool{context_.log, [this] { return last_folder(); }, *tools_menu_,
                               this};  // the window owns it
    QAction* calibrate = tools_menu_->addAction(tr("Calibrate the heads…"));
    calibrate->setObjectName("calibrate_action");
    connect(calibrate, &QAction::triggered, this, [this] {
        pages_->show_page(pages_->profile());
        pages_->profile().calibrate();
    });
    QAction* computer = tools_menu_->addAction(tr("Check this computer"));
    computer->setObjectName("check_computer_action");
    connect(computer, &QAction::triggered, this, [this] {
        pages_->show_page(pages_->realtime());
        pages_->realtime().check_computer();
    });
}

/// Against the job that it carries, or the one that is open here.
void MainWindow::choose_trace_to_verify() {
    const QString path =
        ask_for_file(this, tr("Trace to verify"), last_folder(), tr("Traces (*.trace *.vcd);;All files (*)"));
    if (!path.isEmpty()) context_.judge.judge(path.toStdString(), context_.shown_job());
}

void MainWindow::verify_replay() {
    if (context_.judge.is_judging()) return context_.judge.cancel();
    const replay::Recording::Facts& facts = context_.replay.facts();
    context_.judge.judge(facts.path, facts.job, facts.asked.value_or(verify::AskedCarving{}));
}

void MainWindow::refresh_tools() {
    const bool has_job = context_.open_job.job() != nullptr;
    save_job_->setEnabled(has_job);
    save_tables_->setEnabled(has_job);
    const bool is_judging = context_.judge.is_judging();
    const QString text = is_judging ? tr("Cancel verification") : tr("Verify a trace…");
    if (verify_->text() != text) verify_->setText(text);
    const auto done = context_.judge.take();
    if (!done) return;
    auto* verdict = new VerdictDialog{done, context_.files, this};
    verdict->show();
}

namespace {

constexpr const char* kPanelKeys[SidePanels::kCount] = {"position", "jog", "job"};

}  // namespace

/// What stops the machine stays where it is; the panels may stand elsewhere, on a second screen, say.
void MainWindow::make_panels_menu() {
    QMenu* panels = view_menu_->addMenu(tr("Panels in frames of their own"));
    panels->setObjectName("panels");
    for (std::size_t i = 0; i < SidePanels::kCount; ++i) {
        QAction* action = panels->addAction(SidePanels::name(i));
        action->setObjectName(QStringLiteral("float_%1").arg(kPanelKeys[i]));
        action->setCheckable(true);
        connect(action, &QAction::toggled, this, [this, i](bool floats) { float_panel(i, floats); });
        float_actions_.push_back(action);
        action->setChecked(settings_.is_floating(kPanelKeys[i]));
    }
    QAction* reset = view_menu_->addAction(tr("Reset layout"));
    reset->setObjectName("reset_layout");
    connect(reset, &QAction::triggered, this, [this] {
        for (QAction* action : float_actions_) action->setChecked(false);
        for (const char* key : kPanelKeys) settings_.set_panel_geometry(key, {});
    });
}

/// By settings that came after the first frame.
void MainWindow::show_kept_panels() {
    for (std::size_t i = 0; i < SidePanels::kCount; ++i)
        float_actions_[i]->setChecked(settings_.is_floating(kPanelKeys[i]));
}

void MainWindow::float_panel(std::size_t panel, bool floats) {
    let_go();
    settings_.set_floating(kPanelKeys[panel], floats);
    if (!floats) {
        keep_panel_places();
        return sides_->dock_panel(panel);
    }
    const auto put_back = [this, panel] { float_actions_[panel]->setChecked(false); };
    const auto left = [this] {
        const QWidget* const now = QApplication::activeWindow();
        if (now != this && !sides_->is_ours(now)) let_go();
    };
    sides_->float_panel(panel, this, put_back, left);
    const QByteArray place = settings_.panel_geometry(kPanelKeys[panel]);
    if (!place.isEmpty()) sides_->frame(panel).restoreGeometry(place);
    if (place_keeper_) place_keeper_->watch(sides_->frame(panel));
}

void MainWindow::keep_panel_places() {
    for (std::size_t i = 0; i < SidePanels::kCount; ++i) {
        if (sides_->is_floating(i))
            settings_.set_panel_geometry(kPanelKeys[i], sides_->frame(i).saveGeometry());
    }
}

}  // namespace psicarve::ui
