// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/main_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QMimeData>
#include <QResizeEvent>
#include <QTabBar>
#include <QUrl>
#include <QVBoxLayout>

#include <chrono>
#include <functional>
#include <memory>
#include <utility>

#include "hmi/session/action_lock.hpp"
#include "hmi/session/escape_key.hpp"
#include "hmi/ui/alarm_banner.hpp"
#include "hmi/ui/core_profile_bar.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/first_touch.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/job_panel.hpp"
#include "hmi/ui/jog_panel.hpp"
#include "hmi/ui/model_page.hpp"
#include "hmi/ui/option_keeper.hpp"
#include "hmi/ui/page_tabs.hpp"
#include "hmi/ui/place_keeper.hpp"
#include "hmi/ui/ports_page.hpp"
#include "hmi/ui/position_panel.hpp"
#include "hmi/ui/profile_page.hpp"
#include "hmi/ui/program_ground.hpp"
#include "hmi/ui/program_page.hpp"
#include "hmi/ui/refusal_bar.hpp"
#include "hmi/ui/replay_bar.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/stop_keys.hpp"
#include "hmi/ui/strip.hpp"
#include "hmi/ui/unfinished_bar.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

constexpr QSize kLeastSize{640, 360};
/// So long the first frame waits for the settings; what comes later is taken then.
constexpr std::chrono::milliseconds kSettingsLimit{250};

/// Of a window's; such an event does not come to changeEvent().
class PaletteEar : public QObject {
public:
    PaletteEar(QWidget* window, std::function<void()> changed)
        : QObject(window), changed_(std::move(changed)) {
        window->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        // Looked at when all colours are there.
        if (event->type() == QEvent::ApplicationPaletteChange)
            QTimer::singleShot(0, this, [this] { changed_(); });
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> changed_;
};

}  // namespace

MainWindow::MainWindow(const session::SessionOptions& options, Drawing drawing,
                       std::unique_ptr<SettingsStore> settings)
    : context_(options, std::move(settings)), drawing_(drawing), settings_(*context_.settings) {
    if (!context_.settings->await_read(kSettingsLimit)) first_touch_ = std::make_unique<FirstTouch>(*this);
    context_.settings->set_on_read([this] { take_settings(); });
    setWindowTitle("Psicarve");
    setAcceptDrops(true);
    setMinimumSize(kLeastSize);
    take_place();
    build(Begin::anew);
    ask_ = [this] { return ask_what_to_do(); };
    stop_keys_ =
        std::make_unique<StopKeys>(StopKeys::Acts{[this] { emergency_stop(); }, [this] { return may_stop(); },
                                                  [this] { stop(); }, [this] { return escape_act(); }});
    connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
    timer_.start(kLookPause);
    connect(&language_timer_, &QTimer::timeout, this, [this] { change_language(); });
    new PaletteEar{this, [this] {  // the window owns it
                       if (theme_of(settings_.theme()) != theme_) show_theme();
                   }};
    // The desktop ends without asking once more.
    connect(qApp, &QGuiApplication::commitDataRequest, this, [this] { write_place(); });
}

/// All views, in the language of the moment.
void MainWindow::build(Begin begin) {
    menu_ = new QMenu{this};
    make_menu();
    strip_ = new Strip{context_, menu_};
    position_ = new PositionPanel{context_};
    jog_ = new JogPanel{context_};
    job_ = new JobPanel{context_};
    jog_->set_on_armed(
        [this](bool is_armed) { set_styled(position_, "jog_armed", is_armed ? "yes" : "no"); });
    sides_ = std::make_unique<SidePanels>(context_, position_, jog_, job_);
    auto* middle = new QHBoxLayout;
    middle->setContentsMargins(kGap, kGap, kGap, kGap);
    middle->setSpacing(kGap);
    middle->addWidget(&sides_->left());
    middle->addWidget(make_centre(), 1);
    middle->addWidget(&sides_->right());
    auto* whole = new QWidget;
    whole->setObjectName("window");
    whole->setAttribute(Qt::WA_StyledBackground);
    auto* all = new QVBoxLayout{whole};
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(strip_);
    all->addLayout(middle, 1);
    make_status_bar();
    all->addWidget(status_row_);
    setCentralWidget(whole);
    // There it would be taken for the program's.
    const auto let_keys_start = [this] { job_->let_keys_start(!pages_->is_current(pages_->program())); };
    connect(pages_, &QTabWidget::currentChanged, this, let_keys_start);
    let_keys_start();
    if (begin == Begin::with_work_that_comes) pages_->model().await_work();
    show_theme();
    pages_->tabBar()->setFocus();  // not on anything that moves the machine
    make_panels_menu();
    keep_place();
}

MainWindow::~MainWindow() = default;

QWidget* MainWindow::make_centre() {
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout{centre};
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap);
    banner_ = new AlarmBanner{context_};
    column->addWidget(banner_);
    refusal_ = new RefusalBar{context_};
    column->addWidget(refusal_);
    unfinished_ = new UnfinishedBar{context_};
    column->addWidget(unfinished_);
    core_profile_ = new CoreProfileBar{context_};
    column->addWidget(core_profile_);
    auto* frame = new QFrame;
    frame->setProperty("dock", true);
    auto* inside = new QVBoxLayout{frame};
    inside->setContentsMargins(1, 1, 1, 1);
    pages_ = new PageTabs{context_, drawing_, [this](const QString& path) { open(path); }};
    inside->addWidget(pages_);
    column->addWidget(frame, 1);
    replay_ = new ReplayBar{context_, [this] { choose_job_of_trace(); }, [this] { verify_replay(); }};
    column->addWidget(replay_);
    return centre;
}

void MainWindow::set_theme(ThemeChoice choice) {
    settings_.set_theme(choice);
    show_theme();
}

void MainWindow::show_theme() {
    theme_ = theme_of(settings_.theme());
    const Tokens& tokens = tokens_of(theme_);
    setStyleSheet(style_sheet(tokens, room_in(size()) == Room::wide));
    sides_->buttons().set_theme(tokens);
    strip_->set_theme(tokens);
    position_->set_theme(tokens);
    jog_->set_theme(tokens);
    job_->set_theme(tokens);
    banner_->set_theme(tokens);
    refusal_->set_theme(tokens);
    unfinished_->set_theme(tokens);
    core_profile_->set_theme(tokens);
    pages_->set_theme(tokens);
    replay_->set_theme(tokens);
}

void MainWindow::refresh() {
    context_.poll();
    arrival_.poll();
    refresh_replay();
    strip_->refresh();
    position_->refresh();
    jog_->refresh();
    job_->refresh();
    sides_->buttons().refresh();
    banner_->refresh();
    refusal_->refresh();
    unfinished_->refresh();
    core_profile_->refresh();
    pages_->refresh();
    refresh_tools();
    refresh_status_bar();
    refresh_title();
}

void MainWindow::open(const QString& path) {
    context_.forget_refused_file();
    if (context_.open_job.view().is_busy()) {
        return context_.open_job.refuse(path.toStdString(),
                                        session::phrase("Open: a job is being made; cancel it first"));
    }
    if (arrival_.is_awaited()) {
        return context_.open_job.refuse(path.toStdString(),
                                        session::phrase("Open: the machine's profile is still being read"));
    }
    settings_.add_recent_file(path);
    if (program::is_program_file(path.toStdString())) {
        pages_->show_page(pages_->program());
        return context_.program.open(path.toStdString(), context_.machine.view(), context_.machine_profile());
    }
    context_.open_job.open(path.toStdString());
}

void MainWindow::emergency_stop() {
    strip_->emergency_stop();
    let_go();
}

bool MainWindow::may_stop() const {
    return !program_stop_lock(context_);
}

void MainWindow::stop() {
    let_go();
    stop_program(context_);
    context_.log.add_command(session::Severity::info, session::phrase("Stop asked for"));
}

std::function<void()> MainWindow::escape_act() {
    switch (session::escape_order(context_.machine.view(), context_.machine.has_orders())) {
        case session::EscapeOrder::none:
            if (!context_.program.is_on_its_way(context_.program_report)) return {};
            return [this] { stop(); };
        case session::EscapeOrder::stop:
            return [this] { stop(); };
        case session::EscapeOrder::hold:
            break;
    }
    return [this] {
        context_.machine.order(CommandKind::hold, session::phrase("Hold"));
        context_.log.add_command(session::Severity::info,
                                 session::phrase("Hold asked for by Esc: Resume or the Pause key goes on"));
    };
}

void MainWindow::let_go() {
    jog_->let_go();
    pages_->ports().let_go();
}

void MainWindow::changeEvent(QEvent* event) {
    // A jog ends when the hand may be elsewhere.
    const bool is_elsewhere =
        !isActiveWindow() && (!sides_ || !sides_->is_ours(QApplication::activeWindow()));
    if (event->type() == QEvent::ActivationChange && is_elsewhere && pages_ != nullptr) let_go();
    QMainWindow::changeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    show_room(room_in(event->size()));
    QMainWindow::resizeEvent(event);
}

void MainWindow::show_room(Room room) {
    strip_->set_room(room);
    job_->set_room(room);
    unfinished_->set_room(room);
    core_profile_->set_room(room);
    position_->set_room(room);
    set_styled(pages_->tabBar(), "narrow", room == Room::small ? "yes" : "no");
    show_menu_bar(room == Room::wide);
    if (sides_->arrange(room)) {
        jog_->let_go();
        setStyleSheet(style_sheet(tokens_of(theme_), room == Room::wide));
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) open(urls.front().toLocalFile());
}

/// At rest with a job under way is not at rest for an operator who walks away.
bool MainWindow::is_under_way() const {
    const session::MachineView& view = context_.machine.view();
    return view.is_heard() &&
           (!is_at_rest(view.state()) || view.state() == S::held || view.state() == S::waiting);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (QDialog* const first = open_dialog()) {  // it asks something of this window
        first->raise();
        first->activateWindow();
        return event->ignore();
    }
    let_go();
    if (std::exchange(closes_held_, false)) {  // everything was asked before
        leave();
        return event->accept();
    }
    if (!pages_->profile().may_lose_changes()) return event->ignore();
    const CloseChoice choice = is_under_way() ? ask_() : CloseChoice::leave_running;
    if (choice == CloseChoice::stay_open) return event->ignore();
    if (choice == CloseChoice::hold) {
        close_once_held();
        return event->ignore();
    }
    if (choice == CloseChoice::stop) context_.machine.stop();
    leave();
    event->accept();
}

}  // namespace psicarve::ui
