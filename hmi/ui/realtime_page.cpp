// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/realtime_page.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <utility>

#include "hmi/doctor/checks.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/checked_width.hpp"
#include "hmi/ui/computer_table.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/histogram_view.hpp"
#include "hmi/ui/latency_panel.hpp"

namespace psicarve::ui {
namespace {

constexpr int kRealtimePageTableHeight = 166;
constexpr int kLeastTableHeight = 80;
constexpr int kLeastForTwo = 560;  // px: columns of figures
const QString kNoFigure = QStringLiteral("\u2013");

QString count_of(std::uint64_t count) {
    return QString::fromStdString(session::count_text(static_cast<std::int64_t>(count)));
}

void say(QLabel* label, const QString& text) {
    if (label->text() != text) label->setText(text);
}

}  // namespace

RealtimePage::RealtimePage(WindowContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      facts_(new QGridLayout),
      table_(new ComputerTable),
      histogram_(new HistogramView),
      latency_(new LatencyPanel{context}),
      verdict_(role_label("title")) {
    setObjectName("realtime_page");
    verdict_->setObjectName("realtime_verdict");
    verdict_->setWordWrap(true);
    facts_->setHorizontalSpacing(2 * kGap);
    facts_->setVerticalSpacing(kSmallGap);
    const auto add = [this](const QString& title, const char* name, QLabel*& value) {
        value = role_label("");
        value->setObjectName(name);
        auto* const of = role_label("label", title);
        of->setWordWrap(true);
        value->setWordWrap(true);
        pairs_.emplace_back(of, value);
    };
    add(tr("Tick"), "realtime_period", period_);
    add(tr("Ticks since the core started"), "realtime_ticks", ticks_);
    add(tr("Missed, skipped"), "realtime_missed", missed_);
    add(tr("Late: median, 99 %, 99.9 %"), "realtime_percentiles", percentiles_);
    add(tr("Latest of all"), "realtime_greatest", greatest_);
    add(tr("Real-time rights"), "realtime_rights", rights_);
    add(tr("Ticks per second"), "realtime_rate", rate_);
    add(tr("Pulses per second R1, R2, \u03A8, Y"), "realtime_pulses", pulses_);
    add(tr("Ticks in which a step waited for its pin"), "realtime_waited", waited_);
    add(tr("Page faults, preemptions of the tick"), "realtime_faults", faults_);
    arrange_facts();
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->setSpacing(kGap);
    all->addWidget(verdict_);
    all->addWidget(histogram_, 1);
    all->addLayout(facts_);
    all->addLayout(make_choice());
    table_->setObjectName("computer_table");
    table_->setMinimumHeight(kLeastTableHeight);
    table_->setMaximumHeight(kRealtimePageTableHeight);
    all->addWidget(table_);
    all->addWidget(latency_, 1);
    latency_->hide();
}

/// Two beside each other, or one below the other where a window is narrow.
void RealtimePage::arrange_facts() {
    const int rows = is_narrow_ ? static_cast<int>(pairs_.size()) : static_cast<int>(pairs_.size()) / 2;
    for (int i = 0; i < static_cast<int>(pairs_.size()); ++i) {
        const auto [title, value] = pairs_[static_cast<std::size_t>(i)];
        const int column = 2 * (i / rows);
        facts_->removeWidget(title);
        facts_->removeWidget(value);
        facts_->addWidget(title, i % rows, column);
        facts_->addWidget(value, i % rows, column + 1);
    }
    for (const int column : {0, 1, 2, 3}) {
        const int share = column % 2 == 0 ? 3 : 2;  // words are longer than figures
        facts_->setColumnStretch(column, is_narrow_ && column > 1 ? 0 : share);
    }
}

void RealtimePage::resizeEvent(QResizeEvent* event) {
    const bool is_narrow = event->size().width() < kLeastForTwo;
    choice_->setDirection(is_narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    if (std::exchange(is_narrow_, is_narrow) != is_narrow) {
        arrange_facts();
        layout()->invalidate();
        choice_->update();
    }
    QWidget::resizeEvent(event);
}

void RealtimePage::set_theme(const Tokens& tokens) {
    histogram_->set_theme(tokens);
    table_->set_theme(tokens);
    latency_->set_theme(tokens);
}

QLayout* RealtimePage::make_choice() {
    auto* row = new FlowLayout;
    const auto add = [this, row](const QString& text, const char* name, Shown what) {
        auto* button = new QPushButton{text};
        button->setObjectName(name);
        button->setProperty("small", true);
        button->setCheckable(true);
        button->setAutoExclusive(true);
        leave_room_for_bold(*button);
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QPushButton::clicked, this, [this, what] { show(what); });
        row->addWidget(button);
        return button;
    };
    steps_button_ = add(tr("The core's tick"), "show_steps", Shown::core_steps);
    computer_button_ = add(tr("This computer"), "check_computer", Shown::computer);
    add(tr("Measure"), "show_measurement", Shown::measurement);
    steps_button_->setChecked(true);
    table_note_ = role_label("label");
    table_note_->setObjectName("computer_note");
    table_note_->setWordWrap(true);
    choice_ = new QBoxLayout{QBoxLayout::LeftToRight};
    choice_->setSpacing(kSmallGap);
    choice_->addLayout(row);
    choice_->addWidget(table_note_, 1);
    return choice_;
}

void RealtimePage::check_computer() {
    computer_button_->setChecked(true);
    show(Shown::computer);
}

void RealtimePage::show(Shown what) {
    shown_ = what;
    // What is found here is more to read.
    histogram_->setVisible(what == Shown::core_steps);
    table_->setVisible(what != Shown::measurement);
    latency_->setVisible(what == Shown::measurement);
    table_->setMaximumHeight(what == Shown::core_steps ? kRealtimePageTableHeight : QWIDGETSIZE_MAX);
    if (what == Shown::computer && queue_.is_idle()) {
        queue_.post([this]() -> session::BackgroundQueue::Finish {
            const auto findings = doctor::check_all(doctor::SystemFiles{});
            return [this, findings] { findings_ = session::finding_rows(findings); };
        });
    }
    refresh();
}

void RealtimePage::refresh_table(const CoreStatus* status) {
    if (shown_ == Shown::measurement)
        return say(table_note_, tr("How late the core's ticks would be, beside whatever the computer does"));
    if (shown_ == Shown::computer) {
        say(table_note_, findings_.empty() ? tr("Looking at this computer")
                                           : tr("Touches no machine. Measure does so at length."));
        return table_->show_rows(findings_);
    }
    const auto rows =
        status != nullptr ? session::realtime_rows(*status) : std::vector<session::ComputerRow>{};
    say(table_note_, status == nullptr ? tr("No core has been seen yet")
                     : rows.empty()    ? tr("On the virtual clock nothing has to be in time")
                                       : QString{});
    table_->show_rows(rows);
}

/// On the virtual clock no tick has a time that it could miss.
void RealtimePage::show_lateness(const CoreStatus& status, const session::TickHealth& health) {
    if (status.is_virtual_clock != 0) {
        for (QLabel* label : {missed_, percentiles_, greatest_, faults_}) say(label, kNoFigure);
        return say(rights_, tr("not needed on the virtual clock"));
    }
    say(missed_, count_of(health.missed));
    say(percentiles_, QString::fromStdString(session::duration_text(health.median_ns) + ", " +
                                             session::duration_text(health.p99_ns) + ", " +
                                             session::duration_text(health.p999_ns)));
    say(greatest_, QString::fromStdString(session::duration_text(health.greatest_ns)));
    say(rights_, status.has_realtime_rights != 0 ? tr("granted") : tr("none: ticks may be late"));
    say(faults_, count_of(status.tick_minor_faults + status.tick_major_faults) + ", " +
                     count_of(status.tick_preemptions));
}

void RealtimePage::refresh() {
    queue_.deliver();
    latency_->refresh();
    const auto& view = context_.machine.view();
    if (isVisible()) refresh_table(view.status ? &*view.status : nullptr);
    if (!view.status) {
        say(verdict_, tr("No core has been seen yet"));
        return;
    }
    const CoreStatus& status = *view.status;
    if (view.core_pid != core_pid_) rates_.forget();
    core_pid_ = view.core_pid;
    rates_.note(status, session::RateMeter::Clock::now());
    if (!isVisible()) return;
    const session::TickHealth health = session::tick_health(status);
    if (context_.replay.is_open()) {
        say(verdict_, tr("The live machine, not the recording"));
    } else if (!view.is_heard()) {
        say(verdict_, tr("No core: these are the last figures known"));
    } else if (status.is_virtual_clock != 0) {
        say(verdict_, tr("The core runs on a virtual clock: no tick is ever late"));
    } else if (rates_.missed_lately() > 0) {
        say(verdict_, tr("%1 ticks missed in the last second").arg(rates_.missed_lately()));
    } else if (health.missed > 0) {
        say(verdict_, tr("No tick missed in the last second; %1 before").arg(health.missed));
    } else {
        say(verdict_, tr("No tick missed since the core started"));
    }
    say(period_, QString::fromStdString(session::duration_text(health.period_ns)));
    say(ticks_, count_of(status.tick));
    show_lateness(status, health);
    say(rate_, QString::fromStdString(session::number_text(rates_.ticks_per_s(), 0)));
    QString pulses;
    for (const Axis axis : kAllAxes) {
        if (!pulses.isEmpty()) pulses += ", ";
        pulses += QString::fromStdString(session::number_text(rates_.pulses_per_s(axis), 0));
    }
    say(pulses_, pulses);
    say(waited_, count_of(status.waited_ticks));
    histogram_->show_health(health);
}

}  // namespace psicarve::ui
