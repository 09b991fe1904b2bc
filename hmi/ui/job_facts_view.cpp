// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/job_facts_view.hpp"

#include <QGridLayout>
#include <QLabel>

#include "hmi/session/display_text.hpp"
#include "hmi/session/job_facts.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"
#include "shared/base/units.hpp"

namespace psicarve::ui {
namespace {

constexpr const char* kSourceRows[] = {"job_bound", "job_source", "job_joining", "job_undercut", "job_open"};

const QString kNotKnown = QStringLiteral("–");

QString number(double value, int decimals) {
    return QString::fromStdString(session::number_text(value, decimals));
}

/// "12.0 mm, r ≤ 28.9"
QString size_text(const cam::PreparedJob& job) {
    const auto heights = job.view.layer_heights_pulses().subspan(job.view.finishing_layer());
    const double y_per_mm = axis_motion(job.profile, Axis::y).pulses_per_unit;
    const double rise_mm = mm_from_pulses(heights.back() - heights.front(), y_per_mm);
    const double r1_per_mm = axis_motion(job.profile, Axis::r1).pulses_per_unit;
    const double most_mm = mm_from_pulses(job.view.max_radius_pulses(Axis::r1), r1_per_mm);
    return JobFactsView::tr("%1 mm, r ≤ %2").arg(number(rise_mm, 1), number(most_mm, 1));
}

}  // namespace

JobFactsView::JobFactsView(WindowContext& context, QWidget* parent)
    : QWidget(parent), context_(context), grid_(new QGridLayout{this}) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setVerticalSpacing(1);
    counts_ = add_row(tr("Layers × points"), "job_counts");
    size_ = add_row(tr("Height, radius"), "job_size");
    brief_ = plain_label();
    brief_->setObjectName("job_brief");
    grid_->addWidget(brief_, grid_->rowCount(), 0, 1, 2);
    brief_->hide();
    pass_ = add_row(tr("Pass"), "job_pass");
    time_ = add_row(tr("Time"), "job_time").value;
    reference_ = add_row(tr("T_ref"), "reference");
    reference_.value->setToolTip(tr("The least time that the motors' limits allow for the whole job"));
    for (const char* id : kSourceRows) source_rows_.push_back(add_row({}, id));
    set_room(Room::usual);
}

JobFactsView::Row JobFactsView::add_row(const QString& name, const char* id) {
    const Row row{role_label("label", name), plain_label()};
    row.value->setAlignment(Qt::AlignRight);
    row.value->setObjectName(id);
    const int line = grid_->rowCount();
    grid_->addWidget(row.name, line, 0);
    grid_->addWidget(row.value, line, 1);
    return row;
}

void JobFactsView::set_room(Room room) {
    is_wide_ = room == Room::wide;
    for (const Row& row : source_rows_) {
        row.name->setVisible(is_wide_);
        row.value->setVisible(is_wide_);
    }
}

void JobFactsView::set_brief(bool is_brief) {
    if (is_brief_ == is_brief) return;
    is_brief_ = is_brief;
    for (const Row& row : {counts_, size_, reference_}) {
        row.name->setHidden(is_brief);
        row.value->setHidden(is_brief);
    }
    brief_->setVisible(is_brief);
}

void JobFactsView::show_job(const replay::JobPointer& job) {
    const bool is_replay = context_.replay.is_open();
    show_source(job);
    if (job) {
        return show_size(QString{"%1 × %2"}.arg(job->view.layer_count()).arg(job->view.point_count()),
                         size_text(*job));
    }
    const bool has_mesh = !is_replay && context_.open_job.mesh() != nullptr;
    show_size(has_mesh ? tr("not sliced") : is_replay ? tr("not recorded") : tr("open a model"), kNotKnown);
}

void JobFactsView::show_size(const QString& counts, const QString& size) {
    counts_.value->setText(counts);
    size_.value->setText(size);
    brief_->setText(size == kNotKnown ? counts : QString{"%1, %2"}.arg(counts, size));
}

void JobFactsView::show_source(const replay::JobPointer& job) {
    std::vector<session::FactRow> facts;
    if (job) {
        const auto mesh = context_.open_job.mesh();
        const bool is_of_mesh =
            !context_.replay.is_open() && mesh && mesh->source_name == job->view.source_name();
        facts = session::fact_rows(session::job_facts(job->view),
                                   is_of_mesh ? context_.open_job.mesh_bytes() : 0);
        facts.insert(facts.begin(), {session::phrase("Bound by"), session::bound_phrase(job->least)});
    }
    for (std::size_t i = 0; i < source_rows_.size(); ++i) {
        source_rows_[i].name->setText(i < facts.size() ? words(facts[i].name) : QString{});
        source_rows_[i].value->setText(i < facts.size() ? words(facts[i].value) : QString{});
    }
}

void JobFactsView::show_times(const replay::JobPointer& job) {
    const bool is_replay = context_.replay.is_open();
    const bool is_cores_job = is_replay || (job && job == context_.open_job.core_job());
    const session::JobTimes times =
        session::job_times(context_.shown(), is_cores_job, job && !is_replay ? job->least.total() : 0.0,
                           is_replay ? std::nullopt : context_.estimate.planned(job));
    const session::MachineView& machine_view = context_.shown();
    const bool is_carved = is_cores_job && machine_view.status && machine_view.runs_job();
    const auto layer = is_carved ? std::optional{machine_view.status->layer} : std::nullopt;
    const session::Phrase pass = job ? session::pass_phrase(job->view, layer) : session::Phrase{};
    pass_.value->setText(words(pass));
    for (QLabel* label : {pass_.name, pass_.value}) label->setVisible(!pass.is_empty());
    time_->setText(times.time.is_empty() ? kNotKnown : words(times.time));
    time_->setToolTip(times.is_least
                          ? tr("By feed and top speeds alone; it is planned while the machine is at rest")
                          : QString{});
    reference_.value->setText(times.reference.is_empty() ? kNotKnown : words(times.reference));
}

}  // namespace psicarve::ui
