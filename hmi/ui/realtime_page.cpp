// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/realtime_page.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/histogram_view.hpp"

namespace psicarve::ui {
namespace {

QString text_of(const std::string& text) {
    return QString::fromStdString(text);
}
QString count_of(std::uint64_t count) {
    return text_of(session::count_text(static_cast<std::int64_t>(count)));
}

void say(QLabel* label, const QString& text) {
    if (label->text() != text) label->setText(text);
}

}  // namespace

RealtimePage::RealtimePage(Bench& bench, QWidget* parent)
    : QWidget(parent), bench_(bench), histogram_(new HistogramView), verdict_(role_label("title")) {
    setObjectName("realtime_page");
    verdict_->setObjectName("realtime_verdict");
    auto* facts = new QGridLayout;
    facts->setHorizontalSpacing(2 * kGap);
    facts->setVerticalSpacing(kSmallGap);
    const auto add = [&facts](int row, int column, const QString& title, const char* name, QLabel*& value) {
        value = role_label("");
        value->setObjectName(name);
        facts->addWidget(role_label("label", title), row, column);
        facts->addWidget(value, row, column + 1);
    };
    constexpr int kSecond = 2;  // column
    add(0, 0, tr("Tick"), "realtime_period", period_);
    add(1, 0, tr("Ticks since the core started"), "realtime_ticks", ticks_);
    add(2, 0, tr("Missed, skipped"), "realtime_missed", missed_);
    add(3, 0, tr("Late: median, 99 %, 99.9 %"), "realtime_percentiles", percentiles_);
    add(4, 0, tr("Latest of all"), "realtime_greatest", greatest_);
    add(0, kSecond, tr("Real-time rights"), "realtime_rights", rights_);
    add(1, kSecond, tr("Ticks per second"), "realtime_rate", rate_);
    add(2, kSecond, tr("Pulses per second R1, R2, \u03A8, Y"), "realtime_pulses", pulses_);
    add(3, kSecond, tr("Ticks in which a step waited for its pin"), "realtime_waited", waited_);
    facts->setColumnStretch(1, 1);
    facts->setColumnStretch(kSecond + 1, 1);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->setSpacing(kGap);
    all->addWidget(verdict_);
    all->addWidget(histogram_, 1);
    all->addLayout(facts);
}

void RealtimePage::set_theme(const Tokens& tokens) {
    histogram_->set_theme(tokens);
}

void RealtimePage::refresh() {
    const auto& sight = bench_.machine.sight();
    if (!sight.status) {
        say(verdict_, tr("No core has been seen yet"));
        return;
    }
    const CoreStatus& status = *sight.status;
    if (sight.core_pid != core_pid_) rates_.forget();
    core_pid_ = sight.core_pid;
    rates_.note(status, session::RateMeter::Clock::now());
    if (!isVisible()) return;
    const session::TickHealth health = session::tick_health(status);
    if (bench_.replay.is_open()) {
        say(verdict_, tr("The live machine, not the recording"));
    } else if (!sight.is_heard()) {
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
    say(period_, text_of(session::duration_text(health.period_ns)));
    say(ticks_, count_of(status.tick));
    say(missed_, count_of(health.missed));
    say(percentiles_,
        text_of(session::duration_text(health.median_ns) + ", " + session::duration_text(health.p99_ns) +
                ", " + session::duration_text(health.p999_ns)));
    say(greatest_, text_of(session::duration_text(health.greatest_ns)));
    say(rights_, status.has_realtime_rights != 0 ? tr("granted") : tr("none: ticks may be late"));
    say(rate_, text_of(session::number_text(rates_.ticks_per_s(), 0)));
    QString pulses;
    for (const Axis axis : kAllAxes) {
        if (!pulses.isEmpty()) pulses += ", ";
        pulses += text_of(session::number_text(rates_.pulses_per_s(axis), 0));
    }
    say(pulses_, pulses);
    say(waited_, count_of(status.waited_ticks));
    histogram_->show_health(health);
}

}  // namespace psicarve::ui
