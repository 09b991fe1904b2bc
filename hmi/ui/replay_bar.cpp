// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/replay_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/timeline_view.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kProgressSteps = 1000;
constexpr int kReplayBarTimeWidth = 116;
constexpr int kPlayWidth = 84;

QString text_of(std::int64_t time_ns) {
    return QString::fromStdString(session::time_text_ms(time_ns));
}

}  // namespace

ReplayBar::ReplayBar(WindowContext& context, std::function<void()> choose_job, std::function<void()> verify,
                     QWidget* parent)
    : QFrame(parent),
      context_(context),
      choose_job_(std::move(choose_job)),
      verify_trace_(std::move(verify)) {
    setObjectName("replay_bar");
    setProperty("dock", true);
    opening_ = make_opening();
    controls_ = make_controls();
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kSmallGap, kGap, kSmallGap);
    all->setSpacing(kSmallGap);
    all->addWidget(opening_);
    all->addWidget(controls_);
    setVisible(false);
}

QPushButton* ReplayBar::add_button(QHBoxLayout& row, const char* name, const QString& hint,
                                   std::function<void()> act) {
    auto* button = new QPushButton;
    button->setObjectName(name);
    button->setToolTip(hint);
    button->setAccessibleName(hint);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [act = std::move(act)] { act(); });
    row.addWidget(button);
    return button;
}

QWidget* ReplayBar::make_opening() {
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout{widget};
    row->setContentsMargins(0, 0, 0, 0);
    progress_ = new QProgressBar;
    progress_->setObjectName("replay_progress");
    progress_->setRange(0, kProgressSteps);
    progress_->setTextVisible(false);
    progress_->setProperty("tone", "replay");
    progress_->setAccessibleName(tr("Reading the recording"));
    row->addWidget(role_label("label", tr("Reading the recording")));
    row->addWidget(progress_, 1);
    add_button(*row, "replay_cancel", tr("Cancel reading"), [this] {
        context_.replay.cancel();
    })->setText(tr("Cancel"));
    return widget;
}

QWidget* ReplayBar::make_controls() {
    replay::ReplaySession& replay = context_.replay;
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout;
    row->setSpacing(kSmallGap);
    begin_ = add_button(*row, "replay_begin", tr("To the begin"), [&replay] { replay.clock().seek(0); });
    before_ = add_button(*row, "replay_before", tr("To the entry before (Shift+N)"),
                         [this] { go_to_entry_before(); });
    play_ = add_button(*row, "replay_play", tr("Play or pause (K)"), [this] { play_or_pause(); });
    play_->setFixedWidth(kPlayWidth);
    next_ = add_button(*row, "replay_next", tr("To the next entry (N)"), [this] { go_to_next_entry(); });
    end_ = add_button(*row, "replay_end", tr("To the end"),
                      [&replay] { replay.clock().seek(replay.clock().end_ns()); });
    row->addSpacing(kGap);
    for (const double speed : replay::kReplaySpeeds) {
        const QString text = QStringLiteral("%1\u00D7").arg(speed);
        QPushButton* button = add_button(*row, "", tr("Speed %1 (J slower, L faster)").arg(text),
                                         [&replay, speed] { replay.clock().set_speed(speed); });
        button->setObjectName(QStringLiteral("replay_speed_%1").arg(speed));
        button->setText(text);
        button->setCheckable(true);
        speeds_.push_back(button);
    }
    row->addStretch();
    time_ = role_label("percent");
    time_->setObjectName("replay_time");
    time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    time_->setMinimumWidth(kReplayBarTimeWidth);
    of_ = role_label("label");
    row->addWidget(time_);
    row->addWidget(of_);
    auto* foot = new QHBoxLayout;
    foot->setSpacing(kGap);
    moment_ = role_label("label");
    moment_->setObjectName("replay_moment");
    place_ = role_label("");
    place_->setObjectName("replay_place");
    foot->addWidget(moment_, 1);
    foot->addWidget(place_);
    job_ = add_button(*foot, "replay_job", {}, [this] { use_job(); });
    verify_ = add_button(*foot, "replay_verify", {}, [this] { verify_trace_(); });
    leave_ = add_button(*foot, "replay_leave", tr("Back to the machine"), [&replay] { replay.leave(); });
    leave_->setText(tr("Leave replay"));
    warnings_ = role_label("problem");
    warnings_->setObjectName("replay_warnings");
    warnings_->setWordWrap(true);
    timeline_ = new TimelineView{replay};
    auto* all = new QVBoxLayout{widget};
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(kSmallGap);
    all->addLayout(row);
    all->addWidget(timeline_);
    all->addWidget(warnings_);
    all->addLayout(foot);
    return widget;
}

void ReplayBar::use_job() {
    if (context_.replay.facts().knows_every_pulse) return choose_job_();
    const std::string path = context_.replay.facts().path;
    context_.open_job.open_job(path);
}

void ReplayBar::play_or_pause() {
    replay::ReplayClock& clock = context_.replay.clock();
    if (clock.is_playing()) {
        clock.pause();
    } else {
        clock.play();
    }
}

void ReplayBar::go_to_next_entry() {
    const auto& entries = context_.replay.facts().entries;
    const int next = replay::next_entry(entries, context_.replay.clock().now_ns());
    if (next >= 0) context_.replay.clock().seek(entries[static_cast<std::size_t>(next)].time_ns);
}

void ReplayBar::go_to_entry_before() {
    const auto& entries = context_.replay.facts().entries;
    const int before = replay::entry_before(entries, context_.replay.clock().now_ns());
    if (before >= 0) context_.replay.clock().seek(entries[static_cast<std::size_t>(before)].time_ns);
}

void ReplayBar::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    begin_->setIcon(glyph_icon(Glyph::to_begin, tokens.text, tokens.dis));
    before_->setIcon(glyph_icon(Glyph::entry_before, tokens.text, tokens.dis));
    next_->setIcon(glyph_icon(Glyph::next_entry, tokens.text, tokens.dis));
    end_->setIcon(glyph_icon(Glyph::to_end, tokens.text, tokens.dis));
    shown_playing_ = !context_.replay.clock().is_playing();
    timeline_->set_theme(tokens);
    refresh();
}

void ReplayBar::refresh() {
    const bool is_opening = context_.replay.is_opening();
    const bool is_open = context_.replay.is_open();
    if (isHidden() == (is_opening || is_open)) setVisible(is_opening || is_open);
    if (opening_->isHidden() == is_opening) opening_->setVisible(is_opening);
    if (controls_->isHidden() == is_open) controls_->setVisible(is_open);
    if (is_opening) progress_->setValue(static_cast<int>(kProgressSteps * context_.replay.progress_ratio()));
    if (!is_open || tokens_ == nullptr) return;
    const replay::ReplayClock& clock = context_.replay.clock();
    if (shown_playing_ != clock.is_playing()) {
        shown_playing_ = clock.is_playing();
        play_->setText(shown_playing_ ? tr("Pause") : tr("Play"));
        play_->setIcon(glyph_icon(shown_playing_ ? Glyph::pause : Glyph::play, tokens_->text, tokens_->dis));
    }
    for (std::size_t i = 0; i < speeds_.size(); ++i)
        speeds_[i]->setChecked(clock.speed() == replay::kReplaySpeeds[i]);
    time_->setText(text_of(clock.now_ns()));
    of_->setText(tr("of %1").arg(text_of(clock.end_ns())));
    const bool is_trace = context_.replay.facts().knows_every_pulse;
    job_->setText(is_trace ? tr("Add its job\u2026") : tr("Open its job"));
    const bool has_job = context_.replay.facts().job != nullptr;
    lock_with(*job_, is_trace || has_job ? QString{} : tr("Open its job: this snapshot has none"),
              is_trace ? tr("The job or snapshot that this trace belongs to")
                       : tr("Leaves replay and opens the job in this snapshot"));
    refresh_verify();
    refresh_words();
    timeline_->refresh();
    refresh_warnings();
}

/// Page Messages has the recording's own entries now.
void ReplayBar::refresh_warnings() {
    if (shown_edition_ == context_.replay.edition()) return;
    shown_edition_ = context_.replay.edition();
    QStringList lines;
    for (const session::Phrase& warning : context_.replay.facts().warnings) lines += words(warning);
    warnings_->setText(lines.join('\n'));
    warnings_->setVisible(!lines.isEmpty());
}

void ReplayBar::refresh_verify() {
    const auto& facts = context_.replay.facts();
    const bool is_judging = context_.judge.is_judging();
    verify_->setVisible(facts.knows_every_pulse);
    verify_->setText(is_judging ? tr("Cancel verification") : tr("Verify"));
    lock_with(*verify_, is_judging || facts.job ? QString{} : tr("Verify: add its job first"),
              tr("Holds every pulse against the job"));
    verify_->setAccessibleName(verify_->text());
}

QString ReplayBar::state_words() const {
    const session::MachineView& machine_view = context_.replay.view();
    if (!machine_view.status) return {};
    if (context_.replay.facts().knows_states) return words(session::state_text(machine_view, 0).word);
    const bool has_drives = (machine_view.status->signals & kEnableMask) != 0;
    const bool has_spindle = machine_view.is_active(Signal::spindle);
    if (!has_drives) return tr("Drives are off");
    return has_spindle ? tr("Drives and spindle on") : tr("Drives on, spindle off");
}

void ReplayBar::refresh_words() {
    const auto& entries = context_.replay.facts().entries;
    const int last = replay::entry_at(entries, context_.replay.clock().now_ns());
    QString text = state_words();
    if (last >= 0) {
        const replay::Entry& entry = entries[static_cast<std::size_t>(last)];
        text += QStringLiteral("  \u00B7  %1  %2").arg(text_of(entry.time_ns), words(entry.what));
    }
    moment_->setText(moment_->fontMetrics().elidedText(text, Qt::ElideRight, moment_->width()));
    moment_->setToolTip(text);
    const auto& place = context_.replay.shown().place;
    const auto& job = context_.replay.facts().job;
    place_->setText(place && job ? tr("Layer %1 / %2, point %3 / %4")
                                       .arg(place->layer + 1)
                                       .arg(job->view.layer_count())
                                       .arg(place->point + 1)
                                       .arg(job->view.point_count())
                                 : QString{});
}

}  // namespace psicarve::ui
