// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/strip.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/state_pill.hpp"
#include "hmi/ui/words.hpp"
#include "shared/units.hpp"

namespace psicarve::ui {
namespace {

constexpr int kWideStripHeight = 72;
constexpr QSize kEmergency{200, 56};
constexpr QSize kSmallEmergency{180, 56};
constexpr QSize kWideEmergency{232, 60};
constexpr int kStripHeight = 64;
constexpr int kEmergencyIcon = 28;
constexpr int kHeartWidth = 116;
constexpr int kProgressSteps = 10'000;

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

Strip::Strip(Bench& bench, QMenu* menu, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      menu_button_(new QToolButton),
      pill_(new StatePill),
      heart_(new QLabel),
      tick_(role_label("small")),
      missed_(role_label("small")),
      badge_(role_label("badge")),
      percent_(role_label("percent")),
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
    menu_button_->setMenu(menu);
    menu_button_->setPopupMode(QToolButton::InstantPopup);
    menu_button_->setFixedSize(40, 32);
    menu_button_->setStyleSheet("QToolButton::menu-indicator { image: none; }");
    menu_button_->setToolTip(tr("Menu (F10)"));
    menu_button_->setAccessibleName(tr("Menu"));
    menu_button_->setShortcut(Qt::Key_F10);
    for (QLabel* label : {heart_, tick_, missed_}) label->setFixedWidth(kHeartWidth);
    badge_->setFixedHeight(32);
    progress_->setRange(0, kProgressSteps);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress"));
    emergency_->setProperty("estop", true);
    emergency_->setFixedSize(kEmergency);
    emergency_->setFocusPolicy(Qt::TabFocus);
    emergency_->setAccessibleName(tr("Emergency stop"));
    add_words(*emergency_, emergency_icon_, tr("EMERGENCY STOP"), emergency_second_);
    // On press, not on release.
    connect(emergency_, &QPushButton::pressed, this, [this] { emergency_stop(); });

    auto* above = new QHBoxLayout;
    above->addWidget(percent_);
    above->addStretch();
    above->addWidget(time_);
    auto* work = new QVBoxLayout;
    work->setSpacing(kSmallGap);
    work->addLayout(above);
    work->addWidget(progress_);
    auto* all = new QHBoxLayout{this};
    all->setContentsMargins(kGap, kSmallGap, kGap, kSmallGap);
    all->setSpacing(2 * kGap);
    all->addWidget(menu_button_);
    all->addWidget(pill_);
    all->addLayout(column({heart_, tick_, missed_}));
    all->addWidget(badge_);
    all->addLayout(work, 1);
    all->addWidget(emergency_);
}

void Strip::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    menu_button_->setIcon(glyph_icon(Glyph::menu, tokens.text, tokens.dis));
    emergency_icon_->setPixmap(glyph_pixmap(Glyph::octagon, kEmergencyIcon, tokens.on_fill));
    refresh();
}

void Strip::set_room(Room room) {
    const bool is_wide = room == Room::wide;
    setFixedHeight(is_wide ? kWideStripHeight : kStripHeight);
    emergency_->setFixedSize(is_wide ? kWideEmergency : room == Room::small ? kSmallEmergency : kEmergency);
    pill_->set_narrow(room == Room::small);
    layout()->setSpacing(room == Room::small ? kGap : 2 * kGap);
    // The state's word says as much where room is short.
    for (QWidget* widget :
         {static_cast<QWidget*>(heart_), static_cast<QWidget*>(tick_), static_cast<QWidget*>(missed_)})
        widget->setVisible(room != Room::small);
}

void Strip::emergency_stop() {
    const bool is_silent = bench_.machine.sight().life == session::CoreLife::silent;
    const bool is_there = bench_.machine.emergency_stop();
    if (is_there && is_silent) {
        bench_.log.add(session::Severity::warning,
                       session::phrase("The core is silent: use the switch on the machine"));
    } else if (is_there) {
        bench_.log.add(session::Severity::info, session::phrase("Emergency stop asked for"));
    } else {
        bench_.log.add(session::Severity::warning, session::phrase("No core: use the switch on the machine"));
    }
}

void Strip::refresh() {
    if (tokens_ == nullptr) return;
    const bool is_replay = bench_.replay.is_open();
    refresh_pill();
    refresh_heartbeat();
    if (is_replay) {
        refresh_replay();
    } else {
        refresh_progress();
    }
    badge_->setVisible(is_replay || bench_.machine.sight().is_simulator());
    badge_->setText(is_replay ? tr("REPLAY") : tr("SIMULATOR"));
    emergency_second_->setText(is_replay ? tr("F1 · the live machine") : tr("F1 · works everywhere"));
}

void Strip::refresh_pill() {
    const session::MachineSight& sight = bench_.machine.sight();
    const session::StateText live = session::state_text(sight, bench_.desk.sight().core_layer_count);
    // An alarm of the machine is never hidden by what a recording shows.
    if (!bench_.replay.is_open() || live.tone == session::Tone::alarm) {
        pill_->show_state(live, glyph_of(sight.state(), sight.is_heard()), *tokens_);
        return;
    }
    const session::StateText text{session::phrase("REPLAY"),
                                  session::phrase("Live machine: %1", words(live.word).toStdString()),
                                  session::Tone::replay};
    pill_->show_state(text, Glyph::replay, *tokens_);
}

void Strip::refresh_replay() {
    const replay::ReplayClock& clock = bench_.replay.clock();
    percent_->setText(QString::fromStdString(session::time_text_ms(clock.now_ns())));
    time_->setText(tr("of %1").arg(QString::fromStdString(session::time_text_ms(clock.end_ns()))));
    const double ratio =
        clock.end_ns() > 0 ? static_cast<double>(clock.now_ns()) / static_cast<double>(clock.end_ns()) : 1.0;
    progress_->setValue(static_cast<int>(kProgressSteps * ratio));
    set_styled(progress_, "tone", "replay");
}

void Strip::refresh_heartbeat() {
    const session::MachineSight& sight = bench_.machine.sight();
    const bool is_alive = sight.life == session::CoreLife::alive;
    const bool is_late = sight.life == session::CoreLife::late;
    heart_->setText(is_alive ? tr("✓ CORE ALIVE") : is_late ? tr("! CORE LATE") : tr("× NO CORE"));
    const QColor colour = is_alive ? tokens_->run : is_late ? tokens_->warn : tokens_->text2;
    const QString style = QString{"font-weight: 700; font-size: 12px; color: %1"}.arg(colour.name());
    if (heart_->styleSheet() != style) heart_->setStyleSheet(style);
    if (!sight.is_heard() || !sight.status) {
        tick_->clear();
        missed_->clear();
        return;
    }
    const CoreStatus& status = *sight.status;
    const double tick_us = static_cast<double>(status.period_ns) / static_cast<double>(kNsPerUs);
    const QString clock = status.is_virtual_clock != 0 ? tr("virtual clock") : tr("real clock");
    tick_->setText(tr("tick %1 µs").arg(QString::fromStdString(session::number_text(tick_us, 0))));
    missed_->setText(status.is_virtual_clock != 0
                         ? clock
                         : tr("missed %1")
                               .arg(QString::fromStdString(
                                   session::count_text(static_cast<std::int64_t>(status.missed_ticks)))));
}

void Strip::refresh_progress() {
    const session::MachineSight& sight = bench_.machine.sight();
    const double ratio = session::done_ratio(sight);
    const bool has_job = ratio >= 0.0;
    percent_->setText(has_job ? QString{"%1 %"}.arg(static_cast<int>(100.0 * ratio)) : QString{});
    progress_->setValue(has_job ? static_cast<int>(kProgressSteps * ratio) : 0);
    time_->setText(words(session::time_text(sight)));
    const session::Tone tone = session::state_text(sight, 0).tone;
    set_styled(progress_, "tone",
               tone == session::Tone::alarm  ? "alarm"
               : tone == session::Tone::warn ? "warn"
                                             : "run");
}

}  // namespace psicarve::ui
