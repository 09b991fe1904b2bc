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
using session::DeskState;

constexpr int kSlicingSteps = 1000;

QString state_words(DeskState state) {
    switch (state) {
        case DeskState::empty:
            return SlicingPanel::tr("Nothing is open.");
        case DeskState::opening:
            return SlicingPanel::tr("Reading the file …");
        case DeskState::model:
            return SlicingPanel::tr("Not sliced yet.");
        case DeskState::slicing:
            return SlicingPanel::tr("Slicing …");
        case DeskState::job:
            return SlicingPanel::tr("The job is ready to be published.");
        case DeskState::publishing:
            return SlicingPanel::tr("Publishing …");
        case DeskState::published:
            return SlicingPanel::tr("The core has this job.");
    }
    return {};
}

}  // namespace

SlicingPanel::SlicingPanel(Bench& bench, Acts acts, QWidget* parent) : QWidget(parent), bench_(bench) {
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
    connect(cancel_, &QPushButton::clicked, this, [this] { bench_.desk.cancel(); });
    for (QWidget* part : {static_cast<QWidget*>(state_), static_cast<QWidget*>(reload_),
                          static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)})
        column.addWidget(part);
}

void SlicingPanel::add_buttons(QVBoxLayout& column, std::function<void()> slice) {
    slice_ = new ActionButton{Action::slice, tr("Slice"), std::move(slice)};
    slice_->setObjectName("slice");
    slice_->set_hint(tr("Makes the job's tables (F5)"));
    slice_->setShortcut(Qt::Key_F5);
    publish_ = new ActionButton{Action::publish, tr("Publish"), [this] { bench_.desk.publish(); }};
    publish_->setObjectName("publish");
    publish_->set_hint(tr("Gives the job to the core, which checks it"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kGap);
    buttons->addWidget(slice_, 1);
    buttons->addWidget(publish_, 1);
    column.addLayout(buttons);
}

void SlicingPanel::refresh(bool is_stale) {
    slice_->refresh(bench_);
    publish_->refresh(bench_);
    const session::JobSight& sight = bench_.desk.sight();
    state_->setText(is_stale ? tr("Changed since it was sliced: slice again to take it over.")
                             : state_words(sight.state));
    progress_->setVisible(sight.state == DeskState::slicing);
    progress_->setValue(static_cast<int>(kSlicingSteps * bench_.desk.progress_ratio()));
    cancel_->setVisible(sight.is_busy());
    reload_->setVisible(bench_.desk.has_changed() && !sight.is_busy());
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
    const auto& refusal = bench_.desk.refusal();
    auto lock = bench_.replay.is_open()
                    ? replay::lock()
                    : session::lock_of(Action::slice, bench_.machine.sight(), bench_.desk.sight());
    const std::vector<session::Remedy> by_core{{session::Remedy::Kind::core_profile}};
    if (!lock && refusal && refusal->remedies == by_core && !bench_.knows_core_profile())
        lock = session::phrase("The core's profile is not known: give the window its file, with --profile");
    refusal_->show_refusal(refusal ? &*refusal : nullptr, lock ? words(*lock) : QString{});
}

/// What is locked says why: beside Publish in words, too.
void SlicingPanel::show_publish_reason() {
    const bool is_told = bench_.desk.sight().state == DeskState::published;
    const QString reason = is_told ? QString{} : publish_->reason();
    if (publish_reason_->text() != reason) publish_reason_->setText(reason);
    if (publish_reason_->isHidden() != reason.isEmpty()) publish_reason_->setVisible(!reason.isEmpty());
}

}  // namespace psicarve::ui
