// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/work_bar.hpp"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

#include "hmi/ui/field_value.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/long_names.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;

QPushButton* bar_button(const char* name, const QString& text) {
    auto* button = new QPushButton{text};
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QString offer_text(const UnfinishedWork& work) {
    const QString text = work.is_sliced ? WorkBar::tr("Take up again: %1, %2 layers × %3 points, sliced")
                                        : WorkBar::tr("Take up again: %1, %2 layers × %3 points");
    return text.arg(breakable(short_file_name(work.path.toStdString())),
                    work.fields.value("layers").toString(), work.fields.value("points").toString());
}

/// Nothing is under way with it.
bool is_settled(OpenJobState state) {
    return state == OpenJobState::model || state == OpenJobState::job || state == OpenJobState::published;
}

}  // namespace

WorkBar::WorkBar(WindowContext& context, Form form, QWidget* parent)
    : QFrame(parent),
      context_(context),
      form_(std::move(form)),
      keeper_(*context.settings),
      offer_(role_label("title")),
      note_(role_label("label")),
      take_(bar_button("work_take", tr("Take up again"))) {
    setObjectName("unfinished_work");
    offer_->setObjectName("work_offer");
    note_->setObjectName("work_note");
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, kGap);
    for (QLabel* label : {offer_, note_}) {
        label->setWordWrap(true);
        all->addWidget(label);
    }
    auto* not_wanted = bar_button("work_forget", tr("Forget it"));
    not_wanted->setToolTip(tr("It is not offered again; the file stays"));
    connect(take_, &QPushButton::clicked, this, [this] { take_up(); });
    connect(not_wanted, &QPushButton::clicked, this, [this] { decline(); });
    auto* buttons = new FlowLayout;
    buttons->addWidget(take_);
    buttons->addWidget(not_wanted);
    all->addLayout(buttons);
    setVisible(false);
}

void WorkBar::take_up() {
    if (keeper_.left() == nullptr || context_.open_job.view().is_busy()) return;
    taking_ = Taking{*keeper_.left(), context_.open_job.edition()};
    form_.open(taking_->left.work.path);
}

void WorkBar::decline() {
    if (keeper_.left() != nullptr) keeper_.drop_left(QString{keeper_.left()->id});
    show_offer();
}

void WorkBar::fill_in_taken() {
    if (!taking_ || taking_->is_filled_in || context_.open_job.view().is_busy()) return;
    const UnfinishedWork& work = taking_->left.work;
    const bool is_there = context_.open_job.edition() != taking_->edition_before &&
                          context_.open_job.path() == work.path.toStdString();
    if (!is_there) return taking_.reset();  // cancelled, or refused
    // What another program has made of it since is to be looked at first.
    taking_->is_to_slice = work.is_sliced && context_.open_job.stamp() == work.stamp;
    taking_->is_filled_in = true;
    put_into_fields(*form_.fields, work.fields);
}

/// By another process than this window.
bool WorkBar::is_job_kept() {
    const auto job = context_.open_job.job();
    if (context_.open_job.view().state == OpenJobState::published) published_job_ = job;
    return job && (context_.files.saved_job() == job || published_job_.lock() == job);
}

void WorkBar::keep(std::uint64_t changes, bool is_stale) {
    const session::OpenJob& desk = context_.open_job;
    const Seen seen{desk.edition(), changes, desk.view().state, is_job_kept()};
    if (!is_settled(seen.state) || seen_ == seen) return;
    seen_ = seen;
    const auto stamp = desk.stamp();
    if (!desk.mesh() || !stamp || (seen.is_kept && !is_stale)) return keeper_.forget();
    keeper_.remember({QFileInfo{QString::fromStdString(desk.path())}.absoluteFilePath(), *stamp,
                      desk.job() != nullptr && !is_stale, values_of_fields(*form_.fields)});
}

/// Turning and making another body of it go before; when those are cancelled it is offered still.
void WorkBar::settle_taken() {
    if (!taking_ || !taking_->is_filled_in || context_.open_job.view().is_busy()) return;
    const Taking taken = *std::exchange(taking_, std::nullopt);
    const bool is_here = context_.open_job.view().state == OpenJobState::model &&
                         context_.open_job.path() == taken.left.work.path.toStdString();
    if (!is_here) return;
    // This window has it now.
    if (keeper_.kept() != nullptr) keeper_.drop_left(taken.left.id);
    if (taken.is_to_slice) form_.slice();
}

void WorkBar::show_offer() {
    const WorkKeeper::Left* const left = keeper_.left();
    if (isHidden() == (left != nullptr)) setVisible(left != nullptr);
    if (left == nullptr) return;
    const QString text = offer_text(left->work);
    if (offer_->text() != text) offer_->setText(text);
    offer_->setToolTip(left->work.path);
    const bool is_changed = left->file == WorkKeeper::FileState::changed;
    const QString note =
        is_changed
            ? tr("The file was written since: it comes as it is now, and is not sliced.")
            : tr("A window ended before it was published or saved. Nothing is published, nothing moves.");
    if (note_->text() != note) note_->setText(note);
    const QString why_not = left->file == WorkKeeper::FileState::gone ? tr("The file is not there any more")
                            : context_.open_job.view().is_busy() ? tr("A job is being made; cancel it first")
                                                                 : QString{};
    lock_with(*take_, why_not, tr("Opens the model with the form it had"));
    if (left->file == WorkKeeper::FileState::gone) note_->setText(why_not);
    if (told_ == left->id) return;
    told_ = left->id;
    context_.log.add(session::Severity::info,
                     session::phrase("Not published when a window ended: %1 (page Model)",
                                     QFileInfo{left->work.path}.fileName().toStdString()));
}

void WorkBar::refresh(std::uint64_t changes, bool is_stale) {
    keeper_.poll(WorkKeeper::Clock::now());
    if (taking_ && context_.refused_file() != nullptr) taking_.reset();
    fill_in_taken();
    keep(changes, is_stale);
    settle_taken();
    show_offer();
}

}  // namespace psicarve::ui
