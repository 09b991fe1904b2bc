// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/unfinished_bar.hpp"

#include <QLabel>
#include <QPushButton>

#include <vector>

#include "hmi/session/lost_core.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/anew_dialog.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"
#include "shared/machine_state.hpp"

namespace psicarve::ui {
namespace {

QString in_one_line(const std::vector<session::Phrase>& sentences) {
    QStringList said;
    for (const session::Phrase& each : sentences) said << words(each);
    return said.join(' ');
}

}  // namespace

UnfinishedBar::UnfinishedBar(Bench& bench, QWidget* parent)
    : NoticeBar("unfinished", Glyph::info, parent),
      bench_(bench),
      details_(add_text("details")),
      anew_(new ActionButton{session::Action::from_layer, tr("Start anew…"), [this] { begin_anew(); }}),
      dismiss_(new QPushButton{tr("Dismiss")}) {
    anew_->setObjectName("start_anew");
    anew_->set_hint(tr("Begins with layer 1 again; it asks first"));
    dismiss_->setObjectName("unfinished_dismiss");
    dismiss_->setFocusPolicy(Qt::TabFocus);
    dismiss_->setToolTip(tr("Takes this away until more is carved; it moves and forgets nothing"));
    connect(dismiss_, &QPushButton::clicked, this, [this] {
        dismissed_ = piece();
        dismissed_job_ = job_generation();
        refresh();
    });
    add_button(anew_);
    add_button(dismiss_);
}

void UnfinishedBar::set_room(Room room) {
    is_small_ = room == Room::small;
    refresh();
}

/// What is louder says where to go on itself.
std::optional<session::UnfinishedPiece> UnfinishedBar::piece() const {
    const session::MachineSight& sight = bench_.machine.sight();
    if (bench_.replay.is_open() || session::loud_text(sight)) return std::nullopt;
    return session::unfinished_piece(sight, bench_.desk.sight());
}

std::uint64_t UnfinishedBar::job_generation() const {
    const auto& status = bench_.machine.sight().status;
    return status ? status->job_generation : 0;
}

/// The next piece may come to the same numbers.
void UnfinishedBar::forget_dismissed() {
    const session::MachineSight& sight = bench_.machine.sight();
    const bool is_under_way = sight.is_heard() && runs_job(sight.state());
    if (is_under_way || dismissed_job_ != job_generation()) dismissed_.reset();
}

void UnfinishedBar::begin_anew() {
    const session::RunKind kind = bench_.wanted_run;  // whatever is chosen while it is asked
    if (asked_to_begin_anew(bench_, kind, window())) bench_.machine.start(0, 0, kind);
}

void UnfinishedBar::refresh() {
    forget_dismissed();
    const auto shown = piece();
    if (shown && dismissed_ != shown) dismissed_.reset();
    const bool is_there = shown && !dismissed_;
    set_shown(is_there);
    if (!is_there) return;
    const session::MachineSight& sight = bench_.machine.sight();
    const auto job = bench_.desk.core_job() ? bench_.desk.core_job() : bench_.desk.job();
    const QString all = in_one_line(session::unfinished_details(*shown, sight, job.get()));
    show_text(title(), words(session::unfinished_title(*shown)));
    show_text(*details_, is_small_ ? in_one_line(session::unfinished_needs(*shown, sight)) : all);
    for (QLabel* label : {&title(), details_}) set_plain_tip(*label, all);
    setAccessibleName(title().text());
    setAccessibleDescription(all);
    anew_->refresh(bench_);
}

}  // namespace psicarve::ui
