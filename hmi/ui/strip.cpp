// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/strip.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <chrono>

#include "hmi/session/display_text.hpp"
#include "hmi/session/tick_health.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/last_known.hpp"
#include "hmi/ui/state_pill.hpp"
#include "hmi/ui/words.hpp"
#include "shared/base/units.hpp"

namespace psicarve::ui {
namespace {

constexpr int kWideStripHeight = 72;
constexpr QSize kEmergency{200, 56};
constexpr QSize kSmallEmergency{180, 56};
constexpr QSize kWideEmergency{232, 60};
constexpr int kStripHeight = 64;
constexpr int kEmergencyIcon = 28;
constexpr int kHeartWidth = 132;
constexpr int kSmallHeartWidth = 116;
constexpr int kBadgeHeight = 32;
constexpr int kSmallBadgeHeight = 26;
constexpr int kStripProgressSteps = 10'000;

QVBoxLayout* column(std::initializer_list<QWidget*> widgets) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(0);
    layout->addStretch();
    for (QWidget* widget : widgets) layout->addWidget(widget);
    layout->addStretch();
    return layout;
}

/// Words inside a button, in two sizes; the mouse does not see them.
void add_words(QPushButton& button, QLabel* icon, const QString& title, QLabel* lower) {
    QLabel* const upper = role_label("estop", title);
    for (QLabel* label : {icon, upper, lower}) label->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* row = new QHBoxLayout{&button};
    row->setContentsMargins(kGap, 0, kGap, 0);
    row->addWidget(icon);
    // In two lines the words themselves fill the button.
    lower->setVisible(!title.contains('\n'));
    row->addLayout(column({upper, lower}), 1);
}

}  // namespace

Strip::Strip(WindowContext& context, QMenu* menu, QWidget* parent)
    : QWidget(parent),
      context_(context),
      menu_button_(new QToolButton),
      pill_(new StatePill),
      heart_(new QLabel),
      tick_(role_label("small")),
      missed_(role_label("small")),
      badge_(role_label("badge")),
      percent_(role_label("percent")),
      work_(role_label("label")),
      time_(new QLabel),
      progress_(new QProgressBar),
      emergency_(new QPushButton),
      emergency_icon_(new QLabel),
      emergency_second_(role_label("estop_second")) {
    setObjectName("strip");
    pill_->setObjectName("state_pill");
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(kStripHeight);
    pill_->setObjectName("state_pill");
    menu_button_->setObjectName("menu_button");
    menu_button_->setMenu(menu);
    menu_button_->setPopupMode(QToolButton::InstantPopup);
    menu_button_->setFixedSize(40, 32);
    menu_button_->setStyleSheet("QToolButton::menu-indicator { image: none; }");
    menu_button_->setToolTip(tr("Menu (F10)"));
    menu_button_->setAccessibleName(tr("Menu"));
    for (QLabel* label : {heart_, tick_, missed_}) label->setFixedWidth(kHeartWidth);
    tick_->setObjectName("tick_text");
    work_->setObjectName("work_text");
    work_->hide();
    time_->setObjectName("time_left");
    time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    heart_->setObjectName("heart");
    badge_->setObjectName("badge");
    progress_->setRange(0, kStripProgressSteps);
    progress_->setTextVisible(false);
    progress_->setObjectName("progress");
    progress_->setAccessibleName(tr("Progress"));
    emergency_->setObjectName("emergency_stop");
    emergency_->setProperty("estop", true);
    emergency_->setFixedSize(kEmergency);
    emergency_->setFocusPolicy(Qt::TabFocus);
    emergency_->setAccessibleName(tr("Emergency stop"));
    add_words(*emergency_, emergency_icon_, tr("EMERGENCY STOP"), emergency_second_);
    // On press, not on release.
    connect(emergency_, &QPushButton::pressed, this, [this] { emergency_stop(); });

    above_ = new QHBoxLayout;
    above_->addWidget(percent_);
    above_->addStretch();
    above_->addWidget(work_);
    above_->addStretch();
    above_->addWidget(time_);
    auto* work = new QVBoxLayout;
    work->setSpacing(kSmallGap);
    work->addLayout(above_);
    work->addWidget(progress_);
    auto* all = new QHBoxLayout{this};
    all->setContentsMargins(kGap, kSmallGap, kGap, kSmallGap);
    all->setSpacing(2 * kGap);
    all->addWidget(menu_button_);
    all->addWidget(pill_);
    pulse_ = new QBoxLayout{QBoxLayout::LeftToRight};
    pulse_->addLayout(column({heart_, tick_, missed_}));
    pulse_->addWidget(badge_);
    all->addLayout(pulse_);
    all->addLayout(work, 1);
    all->addWidget(emergency_);
}

void Strip::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    menu_button_->setIcon(glyph_icon(Glyph::menu, tokens.text, tokens.dis));
    emergency_icon_->setPixmap(glyph_pixmap(Glyph::octagon, kEmergencyIcon, tokens.on_fill));
    refresh();
}

void Strip::open_menu() {
    menu_button_->showMenu();
}

void Strip::set_room(Room room) {
    const bool is_wide = room == Room::wide;
    setFixedHeight(is_wide ? kWideStripHeight : kStripHeight);
    emergency_->setFixedSize(is_wide ? kWideEmergency : room == Room::small ? kSmallEmergency : kEmergency);
    pill_->set_room(room);
    work_->setVisible(is_wide);
    menu_button_->setVisible(!is_wide);
    const bool is_small = room == Room::small;
    layout()->setSpacing(is_small ? kGap : 2 * kGap);
    // Where room is short the heartbeat stands below the badge; the figures are in its tip and on Real time.
    pulse_->setDirection(is_small ? QBoxLayout::BottomToTop : QBoxLayout::LeftToRight);
    pulse_->setSpacing(is_small ? 0 : 2 * kGap);
    badge_->setFixedHeight(is_small ? kSmallBadgeHeight : kBadgeHeight);
    heart_->setFixedWidth(is_small ? kSmallHeartWidth : kHeartWidth);
    for (QLabel* figures : {tick_, missed_}) figures->setVisible(!is_small);
    is_short_ = is_small;
    time_->setSizePolicy(is_small ? QSizePolicy::Ignored : QSizePolicy::Preferred, QSizePolicy::Preferred);
    above_->setStretchFactor(time_, is_small ? 1 : 0);
}

void Strip::emergency_stop() {
    if (context_.machine.emergency_stop())
        return context_.log.add_command(session::Severity::info, session::phrase("Emergency stop asked for"));
    context_.log.add(session::Severity::alarm,
                     session::phrase("Nobody heard the emergency stop: it has stopped nothing"),
                     session::phrase("Use the wired emergency stop, or the machine's own switch"));
}

void Strip::refresh() {
    if (tokens_ == nullptr) return;
    const bool is_replay = context_.replay.is_open();
    refresh_pill();
    refresh_heartbeat();
    if (is_replay) {
        refresh_replay();
    } else {
        refresh_progress();
    }
    refresh_badge();
    emergency_second_->setText(is_replay ? tr("F1 · the live machine") : tr("F1 · works everywhere"));
}

void Strip::refresh_pill() {
    const session::MachineView& machine_view = context_.machine.view();
    const session::StateText live =
        session::state_text(machine_view, context_.open_job.view().core_layer_count);
    // An alarm of the machine is never hidden by what a recording shows.
    if (!context_.replay.is_open() || live.tone == session::Tone::alarm) {
        pill_->show_state(live, glyph_of(machine_view.state(), machine_view.is_heard()), *tokens_);
        return;
    }
    const session::StateText text{session::phrase("REPLAY"),
                                  session::phrase("Live machine: %1", words(live.word).toStdString()),
                                  session::Tone::replay};
    pill_->show_state(text, Glyph::replay, *tokens_);
}

/// Violet is what is not the real thing; a real port has its name there.
void Strip::refresh_badge() {
    const session::MachineView& machine_view = context_.machine.view();
    const bool is_replay = context_.replay.is_open();
    const bool is_real = !is_replay && !machine_view.is_simulator();
    const QString port = QString::fromStdString(machine_view.port_name);
    set_styled(badge_, "role", is_real ? "port" : "badge");
    badge_->setText(is_replay ? tr("REPLAY")
                    : is_real ? port.mid(port.lastIndexOf('/') + 1)  // "parport0", "io:0x378"
                              : tr("SIMULATOR"));
    badge_->setToolTip(is_real ? tr("The real machine at port %1").arg(port) : QString{});
    badge_->setVisible(!is_real || (machine_view.status && !port.isEmpty()));
}

void Strip::refresh_replay() {
    work_->clear();
    const replay::ReplayClock& clock = context_.replay.clock();
    percent_->setText(QString::fromStdString(session::time_text_ms(clock.now_ns())));
    show_time(tr("of %1").arg(QString::fromStdString(session::time_text_ms(clock.end_ns()))));
    const double ratio =
        clock.end_ns() > 0 ? static_cast<double>(clock.now_ns()) / static_cast<double>(clock.end_ns()) : 1.0;
    progress_->setValue(static_cast<int>(kStripProgressSteps * ratio));
    set_styled(progress_, "tone", "replay");
}

void Strip::refresh_heartbeat() {
    const session::MachineView& machine_view = context_.machine.view();
    const bool is_alive = machine_view.life == session::CoreLife::alive;
    const bool is_late = machine_view.life == session::CoreLife::late;
    heart_->setText(is_alive ? tr("✓ CORE ALIVE") : is_late ? tr("! CORE LATE") : tr("× NO CORE"));
    const QColor colour = is_alive ? tokens_->run : is_late ? tokens_->warn : tokens_->text2;
    const QString style = QString{"font-weight: 700; font-size: 12px; color: %1"}.arg(colour.name());
    if (heart_->styleSheet() != style) heart_->setStyleSheet(style);
    if (!machine_view.is_heard() || !machine_view.status) {
        tick_->clear();
        missed_->clear();
        heart_->setToolTip({});
        return;
    }
    const CoreStatus& status = *machine_view.status;
    const double tick_us = static_cast<double>(status.period_ns) / static_cast<double>(kNsPerUs);
    const QString clock = status.is_virtual_clock != 0 ? tr("virtual clock") : tr("real clock");
    const QString tick = tr("tick %1 µs").arg(QString::fromStdString(session::number_text(tick_us, 0)));
    tick_->setText(tick);
    if (status.is_virtual_clock != 0) return missed_->setText(clock);
    const QString late =
        tr("p99 %1").arg(QString::fromStdString(session::duration_text(session::late_p99_ns(status))));
    const QString missed =
        tr("missed %1")
            .arg(QString::fromStdString(session::count_text(static_cast<std::int64_t>(status.missed_ticks))));
    tick_->setText(QStringLiteral("%1 · %2").arg(tick, late));
    missed_->setText(missed);
    heart_->setToolTip(tick_->text() + "\n" + missed);
    tick_->setToolTip(tr("99 % of the ticks were no later; page Real time tells more"));
}

/// "12:38 left · ends 15:11", "about 12:38 left · ends about 15:11", "stopped 14:58:07", "held, last known
/// 14:58:07"
QString Strip::time_words() const {
    const session::MachineView& machine_view = context_.machine.view();
    if (!machine_view.is_heard() && machine_view.status) {
        const QString state =
            words(session::phrase("%1", name_of(machine_view.heard_state.value_or(machine_view.state()))));
        return QStringLiteral("%1, %2").arg(state, last_known(machine_view));
    }
    const auto at = session::alarm_time(machine_view);
    if (at && session::is_cut_short(machine_view)) return tr("stopped %1").arg(local_time(*at, "HH:mm:ss"));
    const QString left = words(session::time_text(machine_view, context_.open_job.view().core_layer_count));
    const auto end = session::end_time(machine_view, std::chrono::system_clock::now());
    if (!end) return left;
    const QString clock = local_time(*end, "HH:mm");
    return session::is_time_about(machine_view) ? tr("%1 · ends about %2").arg(left, clock)
                                                : tr("%1 · ends %2").arg(left, clock);
}

/// Where room is short as much as fits, and all of it in the tip.
void Strip::show_time(const QString& text) {
    const QString shown =
        is_short_ ? time_->fontMetrics().elidedText(text, Qt::ElideRight, time_->width()) : text;
    time_->setText(shown);
    time_->setToolTip(shown == text ? QString{} : text);
}

void Strip::refresh_progress() {
    const session::MachineView& machine_view = context_.machine.view();
    const bool is_told = session::tells_of_run(machine_view, context_.open_job.view());
    const double ratio = is_told ? session::done_ratio(machine_view) : -1.0;
    const bool has_job = ratio >= 0.0;
    percent_->setText(has_job ? QString{"%1 %"}.arg(static_cast<int>(100.0 * ratio)) : QString{});
    progress_->setValue(has_job ? static_cast<int>(kStripProgressSteps * ratio) : 0);
    show_time(is_told ? time_words() : tr("No job running"));
    const auto job = context_.job_at_work();
    if (work_->isVisible())
        work_->setText(words(session::work_text(machine_view, job ? job->view.layer_count() : 0,
                                                job ? job->view.point_count() : 0)));
    // An alarm takes nothing from a job that it did not cut short.
    const bool is_other_alarm =
        machine_view.is_heard() && !session::is_cut_short(machine_view) &&
        (machine_view.state() == MachineState::alarm || machine_view.state() == MachineState::backing_off);
    const session::Tone tone =
        is_other_alarm ? session::Tone::run : session::state_text(machine_view, 0).tone;
    set_styled(
        progress_, "tone",
        tone == session::Tone::alarm ? "alarm"
        : tone == session::Tone::warn || !machine_view.is_heard() || session::is_left_undone(machine_view)
            ? "warn"
            : "run");
}

}  // namespace psicarve::ui
