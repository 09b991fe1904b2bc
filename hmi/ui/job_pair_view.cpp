// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/job_pair_view.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <string>

#include "hmi/ui/elided_label.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/job_facts_view.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::JobPlace;

QString name_of_job(const cam::PreparedJob& job) {
    return QString::fromStdString(std::string{job.view.source_name()});
}

void show_if(QWidget& widget, bool is_there) {
    if (widget.isHidden() == is_there) widget.setVisible(is_there);
}

std::optional<session::Phrase> take_over_lock(const WindowContext& context) {
    if (context.open_job.view().is_busy()) return session::phrase("Take over: a job is being made");
    return std::nullopt;
}

}  // namespace

JobPairView::JobPairView(WindowContext& context, QLabel& machine_head, QLabel& machine_note, QWidget* parent)
    : QWidget(parent),
      context_(context),
      machine_head_(machine_head),
      machine_note_(machine_note),
      column_(new QVBoxLayout{this}),
      machine_name_(new ElidedLabel),
      take_over_(new ActionButton{take_over_lock, tr("Take over"),
                                  [this] { context_.open_job.take_over(context_.files.saved_job().get()); }}),
      desk_(new QWidget),
      desk_note_(role_label("small")),
      desk_name_(new ElidedLabel),
      facts_(new JobFactsView{context}) {
    machine_name_->setObjectName("machine_job");
    machine_note_.setObjectName("machine_job_note");
    take_over_->setObjectName("take_over");
    take_over_->setProperty("small", true);
    desk_->setObjectName("desk_block");
    desk_note_->setObjectName("desk_job_note");
    desk_name_->setObjectName("desk_job");
    for (ElidedLabel* name : {machine_name_, desk_name_}) name->setProperty("role", "title");
    make_rows();
}

void JobPairView::make_rows() {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(kSmallGap);
    machine_row_ = new QHBoxLayout;
    machine_row_->setSpacing(kSmallGap);
    machine_row_->addWidget(machine_name_, 1);
    machine_row_->addWidget(take_over_);
    auto* rows = new QVBoxLayout{desk_};
    rows->setContentsMargins(0, kSmallGap, 0, 0);
    rows->setSpacing(kSmallGap);
    auto* head = new QHBoxLayout;
    head->addWidget(role_label("head", tr("On the desk")));
    head->addStretch();
    head->addWidget(desk_note_);
    rows->addLayout(head);
    rows->addWidget(rule());
    rows->addWidget(desk_name_);
    column_->addLayout(machine_row_);
    column_->addWidget(desk_);
    column_->addWidget(facts_);
}

void JobPairView::add_button(QWidget* button) {
    machine_row_->addWidget(button);
}

void JobPairView::set_room(Room room) {
    facts_->set_room(room);
}

void JobPairView::set_density(bool is_close, bool is_brief) {
    facts_->set_brief(is_brief);
    const int gap = is_close ? kSmallGap / 2 : kSmallGap;
    column_->setSpacing(gap);
    desk_->layout()->setSpacing(gap);
    desk_->layout()->setContentsMargins(0, gap, 0, 0);
    for (QWidget* part : {static_cast<QWidget*>(facts_), desk_}) part->updateGeometry();
}

JobPlace JobPairView::place() const {
    return context_.replay.is_open()
               ? JobPlace::machine
               : session::place_in_question(context_.machine.view(), context_.open_job.view(),
                                            context_.open_job.core_job() != nullptr);
}

void JobPairView::refresh() {
    const JobPlace about = place();
    const auto job = context_.replay.is_open()      ? context_.replay.facts().job
                     : about == JobPlace::desk      ? context_.open_job.job()
                     : context_.open_job.core_job() ? context_.open_job.core_job()
                                                    : context_.open_job.job();
    put_facts(about);
    show_machine();
    show_desk();
    const std::uint64_t edition = context_.open_job.edition() + context_.replay.edition();
    if (shown_edition_ != edition || job_ != job) facts_->show_job(job);
    shown_edition_ = edition;
    job_ = job;
    facts_->show_times(job);
}

void JobPairView::put_facts(JobPlace place) {
    const int desk_at = column_->indexOf(desk_);
    const bool is_above = column_->indexOf(facts_) < desk_at;
    if (is_above == (place == JobPlace::machine)) return;
    column_->removeWidget(facts_);
    column_->insertWidget(place == JobPlace::machine ? column_->indexOf(desk_) : column_->count(), facts_);
}

void JobPairView::show_machine() {
    const bool is_replay = context_.replay.is_open();
    machine_head_.setText(is_replay ? tr("Job") : tr("Job in the machine"));
    machine_note_.setText(is_replay ? tr("recorded")
                                    : words(session::machine_job_note(context_.machine.view())));
    const auto job = context_.job_at_work();
    const session::MachineView& machine_view = context_.machine.view();
    const bool has_one = machine_view.status && machine_view.status->job_generation != 0;
    const bool is_unread = !is_replay && (has_one || machine_view.life == session::CoreLife::none);
    machine_name_->show_text(job ? name_of_job(*job) : is_unread ? QStringLiteral("–") : tr("No job"));
    const bool is_other = !is_replay && job && job != context_.open_job.job();
    show_if(*take_over_, is_other);
    if (!is_other) return;
    const QString name = name_on_desk();
    take_over_->set_hint(name.isEmpty() ? tr("Puts this job on the desk")
                                        : tr("Puts this job on the desk in place of %1").arg(name));
    take_over_->refresh(context_);
}

void JobPairView::show_desk() {
    const bool is_replay = context_.replay.is_open();
    show_if(*desk_, !is_replay);
    if (is_replay) return;
    const session::OpenJobView& machine_view = context_.open_job.view();
    desk_note_->setText(words(session::desk_job_note(machine_view)));
    const QString name = name_on_desk();
    desk_name_->show_text(name);
    show_if(*desk_name_, machine_view.state != session::OpenJobState::published && !name.isEmpty());
}

QString JobPairView::name_on_desk() const {
    if (const auto job = context_.open_job.job()) return name_of_job(*job);
    const auto mesh = context_.open_job.mesh();
    return mesh ? QString::fromStdString(mesh->source_name) : QString{};
}

}  // namespace psicarve::ui
