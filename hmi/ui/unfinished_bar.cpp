// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/unfinished_bar.hpp"

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <vector>

#include "hmi/session/lost_core.hpp"
#include "hmi/session/saved_piece.hpp"
#include "hmi/session/start_place.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/anew_dialog.hpp"
#include "hmi/ui/disk_piece_dialog.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::ui {
namespace {

QString in_one_line(const std::vector<session::Phrase>& sentences) {
    QStringList said;
    for (const session::Phrase& each : sentences) said << words(each);
    return said.join(' ');
}

}  // namespace

UnfinishedBar::UnfinishedBar(WindowContext& context, QWidget* parent)
    : NoticeBar("unfinished", Glyph::info, parent),
      context_(context),
      details_(add_text("details")),
      from_begin_(new ActionButton{session::Action::from_layer, QString{}, [this] { begin_layer_anew(); }}),
      anew_(new ActionButton{session::Action::from_layer, tr("Start anew…"), [this] { begin_anew(); }}),
      open_(new QPushButton{tr("Open its job")}),
      forget_(new QPushButton{tr("Forget…")}),
      dismiss_(new QPushButton{tr("Dismiss")}),
      ways_out_(new QBoxLayout{QBoxLayout::LeftToRight}) {
    from_begin_->setObjectName("continue_layer");
    from_begin_->set_hint(tr("Carves the begun layer once more from its begin"));
    anew_->setObjectName("start_anew");
    anew_->set_hint(tr("Begins with layer 1 again; it asks first"));
    open_->setObjectName("unfinished_open");
    open_->setFocusPolicy(Qt::TabFocus);
    open_->setToolTip(tr("Opens the copy of the job that the core has kept; it publishes and moves nothing"));
    connect(open_, &QPushButton::clicked, this, [this] {
        if (const FoundCheckpoint* found = saved_piece()) context_.open_job.open_job(found->job_path);
    });
    forget_->setObjectName("unfinished_forget");
    forget_->setFocusPolicy(Qt::TabFocus);
    forget_->setToolTip(tr("Forgets for good how far this piece is carved; it asks first and moves nothing"));
    connect(forget_, &QPushButton::clicked, this, [this] { forget_when_asked(context_, window()); });
    dismiss_->setObjectName("unfinished_dismiss");
    dismiss_->setFocusPolicy(Qt::TabFocus);
    dismiss_->setToolTip(tr("Takes this away until more is carved; it moves and forgets nothing"));
    connect(dismiss_, &QPushButton::clicked, this, [this] { dismiss(); });
    ways_out_->setSpacing(kSmallGap);
    ways_out_->addWidget(forget_);
    ways_out_->addWidget(dismiss_);
    add_button(from_begin_);
    add_button(anew_);
    add_button(open_);
    add_buttons(ways_out_);
}

void UnfinishedBar::set_room(Room room) {
    is_small_ = room == Room::small;
    // Below each other they leave the words more of a narrow window.
    ways_out_->setDirection(is_small_ ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    open_->setText(is_small_ ? tr("Open") : tr("Open its job"));
    refresh();
}

/// What is louder says where to go on itself.
std::optional<session::UnfinishedPiece> UnfinishedBar::piece() const {
    const session::MachineView& view = context_.machine.view();
    if (context_.replay.is_open() || session::loud_text(view)) return std::nullopt;
    return session::unfinished_piece(view, context_.open_job.view());
}

const FoundCheckpoint* UnfinishedBar::saved_piece() const {
    const session::MachineView& view = context_.machine.view();
    if (context_.replay.is_open() || session::loud_text(view) || !view.saved_piece) return nullptr;
    if (!session::may_be_saved(view)) return nullptr;
    return context_.open_job.view().state == session::OpenJobState::empty ? &*view.saved_piece : nullptr;
}

void UnfinishedBar::dismiss() {
    const FoundCheckpoint* const found = saved_piece();
    dismissed_ = piece();
    dismissed_job_ = job_generation();
    if (!dismissed_ && found != nullptr) dismissed_saved_ = found->saved.checkpoint.check;
    refresh();
}

std::uint64_t UnfinishedBar::job_generation() const {
    const auto& status = context_.machine.view().status;
    return status ? status->job_generation : 0;
}

/// The next piece may come to the same numbers.
void UnfinishedBar::forget_dismissed() {
    const session::MachineView& view = context_.machine.view();
    const bool is_under_way = view.is_heard() && view.runs_job();
    if (is_under_way || dismissed_job_ != job_generation()) dismissed_.reset();
}

void UnfinishedBar::begin_anew() {
    const session::RunKind kind = context_.wanted_run;  // whatever is chosen while it is asked
    if (asked_to_begin_anew(context_, kind, window())) context_.machine.start(0, 0, kind);
}

void UnfinishedBar::begin_layer_anew() {
    const auto begun = piece();
    if (begun && begun->carved_layers != 0)
        context_.machine.start(begun->carved_layers, 0, context_.wanted_run);
}

void UnfinishedBar::refresh() {
    forget_dismissed();
    const auto shown = piece();
    if (shown && dismissed_ != shown) dismissed_.reset();
    const FoundCheckpoint* found = shown ? nullptr : saved_piece();
    if (found != nullptr && found->saved.checkpoint.check == dismissed_saved_) found = nullptr;
    const bool is_piece = shown && !dismissed_;
    const bool is_there = is_piece || found != nullptr;
    set_shown(is_there);
    if (!is_there) return;
    if (anew_->isHidden() == is_piece) anew_->setVisible(is_piece);
    // In a small window From layer offers the same.
    const bool is_within = is_piece && shown->next_point && shown->carved_layers != 0 && !is_small_;
    if (from_begin_->isHidden() == is_within) from_begin_->setVisible(is_within);
    const bool can_forget = found != nullptr || context_.machine.view().is_checkpoint_from_disk;
    if (forget_->isHidden() == can_forget) forget_->setVisible(can_forget);
    const bool can_open = found != nullptr && !found->job_path.empty();
    if (open_->isHidden() == can_open) open_->setVisible(can_open);
    if (is_piece) {
        show_piece(*shown);
    } else {
        show_saved(*found);
    }
}

void UnfinishedBar::show_piece(const session::UnfinishedPiece& piece) {
    const session::MachineView& view = context_.machine.view();
    const auto job = context_.open_job.core_job() ? context_.open_job.core_job() : context_.open_job.job();
    const QString all = in_one_line(session::unfinished_details(piece, view, job.get()));
    show_texts(words(session::unfinished_title(piece)),
               is_small_ ? in_one_line(session::unfinished_needs(piece, view)) : all, all);
    anew_->refresh(context_);
    const QString text = words(session::continue_text({piece.carved_layers, {}}));
    if (from_begin_->text() != text) from_begin_->setText(text);
    from_begin_->refresh(context_);
}

void UnfinishedBar::show_saved(const FoundCheckpoint& found) {
    const Checkpoint& checkpoint = found.saved.checkpoint;
    const QString all = in_one_line(session::saved_details(found, context_.machine.view()));
    if (is_small_) {
        const session::UnfinishedPiece piece{checkpoint.next_layer, checkpoint.earlier_layer,
                                             checkpoint.layer_count};
        return show_texts(words(session::unfinished_title(piece)),
                          in_one_line(session::saved_needs(found, context_.machine.view())), all);
    }
    SavedCheckpoint titled = found.saved;
    titled.source_name = short_file_name(titled.source_name).toStdString();
    show_texts(breakable(words(session::saved_title(titled))), all, all);
}

void UnfinishedBar::show_texts(const QString& heading, const QString& details, const QString& all) {
    show_text(title(), heading);
    show_text(*details_, details);
    for (QLabel* label : {&title(), details_}) set_plain_tip(*label, all);
    setAccessibleName(heading);
    setAccessibleDescription(all);
}

}  // namespace psicarve::ui
