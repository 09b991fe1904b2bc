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
#include <QScreen>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

#include "hmi/session/action_lock.hpp"
#include "hmi/ui/alarm_banner.hpp"
#include "hmi/ui/carving_page.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/entries_page.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/job_panel.hpp"
#include "hmi/ui/jog_panel.hpp"
#include "hmi/ui/layers_page.hpp"
#include "hmi/ui/messages_page.hpp"
#include "hmi/ui/model_page.hpp"
#include "hmi/ui/ports_page.hpp"
#include "hmi/ui/position_panel.hpp"
#include "hmi/ui/profile_page.hpp"
#include "hmi/ui/realtime_page.hpp"
#include "hmi/ui/replay_bar.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/stop_keys.hpp"
#include "hmi/ui/strip.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

constexpr std::chrono::milliseconds kFrame{33};
constexpr QSize kUsualSize{1280, 720};
constexpr QSize kLeastSize{640, 360};

/// At rest with a job under way is not at rest for somebody who walks away.
bool is_under_way(const session::MachineSight& sight) {
    return sight.is_heard() &&
           (!is_at_rest(sight.state()) || sight.state() == S::held || sight.state() == S::waiting);
}

}  // namespace

MainWindow::MainWindow(const session::SessionOptions& options, Drawing drawing)
    : bench_(options), drawing_(drawing), menu_(new QMenu{this}) {
    setWindowTitle("Psicarve");
    setAcceptDrops(true);
    make_menu();
    strip_ = new Strip{bench_, menu_};
    position_ = new PositionPanel{bench_};
    jog_ = new JogPanel{bench_};
    job_ = new JobPanel{bench_};
    sides_ = std::make_unique<SidePanels>(bench_, position_, jog_, job_);
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
    setMinimumSize(kLeastSize);
    resize(kUsualSize.boundedTo(screen()->availableSize()));
    restoreGeometry(settings_.geometry());
    set_theme(settings_.theme());
    tabs_->tabBar()->setFocus();  // not on anything that moves the machine
    ask_ = [this] { return ask_what_to_do(); };
    stop_keys_ = std::make_unique<StopKeys>([this] { emergency_stop(); }, [this] { return may_stop(); },
                                            [this] { stop(); });
    connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
    timer_.start(kFrame);
}

MainWindow::~MainWindow() = default;

QWidget* MainWindow::make_centre() {
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout{centre};
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap);
    banner_ = new AlarmBanner{bench_};
    column->addWidget(banner_);
    auto* frame = new QFrame;
    frame->setProperty("dock", true);
    auto* inside = new QVBoxLayout{frame};
    inside->setContentsMargins(1, 1, 1, 1);
    tabs_ = new QTabWidget;
    tabs_->setDocumentMode(true);
    tabs_->tabBar()->setDrawBase(false);
    model_ = new ModelPage{bench_, drawing_};
    layers_ = new LayersPage{bench_};
    carving_ = new CarvingPage{bench_, drawing_};
    ports_ = new PortsPage{bench_};
    realtime_ = new RealtimePage{bench_};
    messages_ = new MessagesPage{bench_};
    profile_ = new ProfilePage{bench_};
    entries_ = new EntriesPage{bench_};
    messages_or_entries_ = new QStackedWidget;
    messages_or_entries_->addWidget(messages_);
    messages_or_entries_->addWidget(entries_);
    const std::initializer_list<QWidget*> pages{
        model_, layers_, carving_, ports_, realtime_, messages_or_entries_, profile_};
    for (QWidget* page : pages) tabs_->addTab(page, QString{});
    name_tabs();
    // In a small window pages may be larger than their room.
    auto* room = new QScrollArea;
    room->setObjectName("pages");
    room->setWidgetResizable(true);
    room->setFrameShape(QFrame::NoFrame);
    room->setWidget(tabs_);
    inside->addWidget(room);
    column->addWidget(frame, 1);
    replay_ = new ReplayBar{bench_, [this] { choose_job_of_trace(); }};
    column->addWidget(replay_);
    return centre;
}

void MainWindow::name_tabs() {
    if (messages_->isVisible()) read_messages_ = bench_.log.count();
    int unread = 0;
    const auto& all = bench_.log.messages();
    const auto fresh = std::min<std::uint64_t>(bench_.log.count() - read_messages_, all.size());
    for (auto i = all.size() - fresh; i < all.size(); ++i)
        unread += all[i].severity != session::Severity::info ? 1 : 0;
    const auto counted = [](const QString& name, std::size_t count) {
        return count > 0 ? QStringLiteral("%1 (%2)").arg(name).arg(count) : name;
    };
    const QString names[] = {tr("Model"),
                             tr("Layers"),
                             tr("Carving"),
                             tr("Ports"),
                             tr("Real time"),
                             counted(tr("Messages"), static_cast<std::size_t>(unread)),
                             counted(tr("Profile"), profile_->problem_count())};
    for (int i = 0; i < tabs_->count(); ++i) {
        if (tabs_->tabText(i) != names[i]) tabs_->setTabText(i, names[i]);
    }
}

void MainWindow::make_status_bar() {
    constexpr int kHeight = 24;
    status_row_ = new QWidget;
    status_row_->setObjectName("statusbar");
    status_row_->setAttribute(Qt::WA_StyledBackground);
    status_row_->setFixedHeight(kHeight);
    auto* row = new QHBoxLayout{status_row_};
    row->setContentsMargins(kGap, 0, kGap, 0);
    row->setSpacing(2 * kGap);
    last_message_ = role_label("label");
    profile_label_ = role_label("label");
    row->addWidget(last_message_, 1);
    row->addWidget(role_label("label", "mm · °"));
    row->addWidget(profile_label_);
    row->addWidget(role_label(
        "label", tr("segment %1").arg(QString::fromStdString(bench_.machine.options().segment_name))));
}

void MainWindow::set_theme(ThemeChoice choice) {
    settings_.set_theme(choice);
    const Tokens& tokens = tokens_of(theme_of(choice));
    setStyleSheet(style_sheet(tokens, room_in(size()) == Room::wide));
    sides_->buttons().set_theme(tokens);
    strip_->set_theme(tokens);
    position_->set_theme(tokens);
    jog_->set_theme(tokens);
    job_->set_theme(tokens);
    banner_->set_theme(tokens);
    model_->set_theme(tokens);
    layers_->set_theme(tokens);
    carving_->set_theme(tokens);
    ports_->set_theme(tokens);
    realtime_->set_theme(tokens);
    messages_->set_theme(tokens);
    profile_->set_theme(tokens);
    entries_->set_theme(tokens);
    replay_->set_theme(tokens);
}

void MainWindow::refresh() {
    bench_.poll();
    refresh_replay();
    strip_->refresh();
    position_->refresh();
    jog_->refresh();
    job_->refresh();
    sides_->buttons().refresh();
    banner_->refresh();
    model_->refresh();
    layers_->refresh();
    carving_->refresh();
    ports_->refresh();
    realtime_->refresh();
    messages_->refresh();
    profile_->refresh();
    name_tabs();
    refresh_status_bar();
}

void MainWindow::refresh_status_bar() {
    const auto& profile = bench_.shown().profile;
    profile_label_->setText(profile ? tr("profile %1").arg(QString::fromStdString(profile->name))
                                    : tr("profile unknown"));
    if (shown_messages_ == bench_.log.count()) return;
    shown_messages_ = bench_.log.count();
    const session::Message& last = bench_.log.messages().back();
    const QString text = words(last.what);
    last_message_->setText(last_message_->fontMetrics().elidedText(text, Qt::ElideRight, width() / 2));
    last_message_->setToolTip(text);
}

void MainWindow::open(const QString& path) {
    if (bench_.desk.sight().is_busy()) {
        bench_.log.add(session::Severity::warning,
                       session::phrase("Open: a job is being made; cancel it first"));
        return;
    }
    settings_.add_recent_file(path);
    bench_.desk.open(path.toStdString());
}

void MainWindow::show_profile(const QString& path) {
    profile_->open(path);
}

void MainWindow::emergency_stop() {
    strip_->emergency_stop();
    let_go();
}

bool MainWindow::may_stop() const {
    return !session::lock_of(session::Action::stop, bench_.machine.sight(), bench_.desk.sight());
}

void MainWindow::stop() {
    let_go();
    bench_.machine.stop();
    bench_.log.add(session::Severity::info, session::phrase("Stop asked for"));
}

void MainWindow::let_go() {
    jog_->let_go();
    ports_->let_go();
}

void MainWindow::changeEvent(QEvent* event) {
    // A jog ends when the hand may be elsewhere.
    if (event->type() == QEvent::ActivationChange && !isActiveWindow() && ports_ != nullptr) let_go();
    QMainWindow::changeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    const Room room = room_in(event->size());
    strip_->set_room(room);
    if (sides_->arrange(room)) {
        jog_->let_go();
        setStyleSheet(style_sheet(tokens_of(theme_of(settings_.theme())), room == Room::wide));
    }
    QMainWindow::resizeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) open(urls.front().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (QDialog* const first = open_dialog()) {  // it asks something of this window
        first->raise();
        first->activateWindow();
        return event->ignore();
    }
    let_go();
    const CloseChoice choice = is_under_way(bench_.machine.sight()) ? ask_() : CloseChoice::leave_running;
    if (choice == CloseChoice::stay_open) return event->ignore();
    if (choice == CloseChoice::hold) bench_.machine.order_and_wait(CommandKind::hold);
    if (choice == CloseChoice::stop) bench_.machine.stop();
    bench_.desk.cancel();
    settings_.set_geometry(saveGeometry());
    timer_.stop();
    event->accept();
}

}  // namespace psicarve::ui
