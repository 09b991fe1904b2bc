// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/slicing_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/refusal_card.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::Action;
using session::OpenJobState;

constexpr int kSlicingSteps = 1000;

QString state_words(OpenJobState state) {
    switch (state) {
        case OpenJobState::empty:
            return SlicingPanel::tr("Nothing is open.");
        case OpenJobState::opening:
            return SlicingPanel::tr("Reading the file …");
        case OpenJobState::model:
            return SlicingPanel::tr("Not sliced yet.");
        case OpenJobState::slicing:
            return SlicingPanel::tr("Slicing …");
        case OpenJobState::job:
            return SlicingPanel::tr("The job is ready to be published.");
        case OpenJobState::publishing:
            return SlicingPanel::tr("Publishing …");
        case OpenJobState::published:
            return SlicingPanel::tr("The core has this job.");
    }
    return {};
}

}  // namespace

SlicingPanel::SlicingPanel(WindowContext& context, Acts acts, QWidget* parent)
    : QWidget(parent), context_(context) {
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins(0, 0, 0, 0);
    refusal_ = new RefusalCard{std::move(acts.remedy)};
    column->addWidget(refusal_);
    add_state(*column, acts.reload);
    add_buttons(*column, std::move(acts.slice));
    publish_reason_ = role_label("label");
    publish_reason_->setObjectName("publish_reason");
    publish_reason_->setWordWrap(true);
    column->addWidget(publish_reason_);
}

void SlicingPanel::add_state(QVBoxLayout& column, const std::function<void()>& reload) {
    state_ = new QLabel;
    state_->setObjectName("desk_state");
    state_->setWordWrap(true);
    progress_ = new QProgressBar;
    progress_->setRange(0, kSlicingSteps);
    progress_->setTextVisible(false);
    reload_ = new QPushButton{tr("Reload")};
    reload_->setObjectName("reload");
    reload_->setFocusPolicy(Qt::TabFocus);
    reload_->setToolTip(tr("The file was written since it was opened"));
    connect(reload_, &QPushButton::clicked, this, reload);
    cancel_ = new QPushButton{tr("Cancel")};
    cancel_->setObjectName("cancel");
    cancel_->setFocusPolicy(Qt::TabFocus);
    connect(cancel_, &QPushButton::clicked, this, [this] { context_.open_job.cancel(); });
    for (QWidget* part : {static_cast<QWidget*>(state_), static_cast<QWidget*>(reload_),
                          static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)})
        column.addWidget(part);
}

void SlicingPanel::add_buttons(QVBoxLayout& column, std::function<void()> slice) {
    slice_ = new ActionButton{Action::slice, tr("Slice"), std::move(slice)};
    slice_->setObjectName("slice");
    slice_->set_hint(tr("Makes the job's tables (F5)"));
    slice_->setShortcut(Qt::Key_F5);
    publish_ = new ActionButton{Action::publish, tr("Publish"), [this] { context_.open_job.publish(); }};
    publish_->setObjectName("publish");
    publish_->set_hint(tr("Gives the job to the core, which checks it"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kGap);
    buttons->addWidget(slice_, 1);
    buttons->addWidget(publish_, 1);
    column.addLayout(buttons);
}

void SlicingPanel::refresh(bool is_stale) {
    slice_->refresh(context_);
    publish_->refresh(context_);
    const session::OpenJobView& job_view = context_.open_job.view();
    state_->setText(is_stale ? tr("Changed since it was sliced: slice again to take it over.")
                             : state_words(job_view.state));
    progress_->setVisible(job_view.state == OpenJobState::slicing);
    progress_->setValue(static_cast<int>(kSlicingSteps * context_.open_job.progress_ratio()));
    cancel_->setVisible(job_view.is_busy());
    reload_->setVisible(context_.open_job.has_changed() && !job_view.is_busy());
    show_publish_reason();
    show_refusal();
}

void SlicingPanel::take_refusal_back() {
    static_cast<QVBoxLayout*>(layout())->insertWidget(0, refusal_);
}

void SlicingPanel::set_theme(const Tokens& tokens) {
    refusal_->set_theme(tokens);
}

void SlicingPanel::show_refusal() {
    const auto& refusal = context_.open_job.refusal();
    auto lock = context_.replay.is_open()
                    ? replay::lock()
                    : session::lock_of(Action::slice, context_.machine.view(), context_.open_job.view());
    const std::vector<session::Remedy> by_core{{session::Remedy::Kind::core_profile}};
    if (!lock && refusal && refusal->remedies == by_core && !context_.knows_core_profile())
        lock = session::phrase("The core's profile is not known: give the window its file, with --profile");
    refusal_->show_refusal(refusal ? &*refusal : nullptr, lock ? words(*lock) : QString{});
}

/// What is locked says why: beside Publish in words, too.
void SlicingPanel::show_publish_reason() {
    const bool is_told = context_.open_job.view().state == OpenJobState::published;
    const QString reason = is_told ? QString{} : publish_->reason();
    if (publish_reason_->text() != reason) publish_reason_->setText(reason);
    if (publish_reason_->isHidden() != reason.isEmpty()) publish_reason_->setVisible(!reason.isEmpty());
}

}  // namespace psicarve::ui
