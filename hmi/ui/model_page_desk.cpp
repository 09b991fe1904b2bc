// SPDX-License-Identifier: GPL-3.0-or-later
// What is on the desk, and the form that it is made a job by.
#include <QScrollArea>

#include <utility>

#include "hmi/ui/field_value.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/model_form.hpp"
#include "hmi/ui/model_page.hpp"
#include "hmi/ui/piece_panel.hpp"
#include "hmi/ui/turn_form.hpp"

namespace psicarve::ui {

using session::OpenJobState;

void ModelPage::slice() {
    sliced_changes_ = changes_;
    context_.open_job.slice(options(), form_->profile_for(context_.machine_profile()));
}

void ModelPage::take_remedy(const session::Remedy& remedy) {
    // Where the window goes by the core's already there is nothing to take.
    const bool has_another = context_.knows_core_profile() && !context_.machine.view().unused_profile.empty();
    if (remedy.kind == session::Remedy::Kind::core_profile && has_another) context_.take_core_profile();
    form_->take(remedy);
    slice();
}

session::TableWay ModelPage::table_way() const {
    return {form_->profile_for(context_.machine_profile()), form_->options().joining};
}

/// As both forms have it.
cam::JobOptions ModelPage::options() const {
    cam::JobOptions options = form_->options();
    if (!turn_->fits()) return options;
    options.fits = true;
    options.height_mm.reset();
    options.scale.reset();
    return options;
}

void ModelPage::turn_model() {
    context_.open_job.turn(turn_->turn());
}

/// What is to be as large as fits has to fit another blank, too.
void ModelPage::refit() {
    const BlankProfile blank = form_->profile_for(context_.machine_profile()).blank;
    if (blank == std::exchange(fitted_blank_, blank) || !turn_->fits()) return;
    look();
}

/// Grooves are as wide as the machine's tool: with another one the drawing is cut anew.
void ModelPage::keep_engraving_cut() {
    if (context_.open_job.kind() != flat::ModelKind::drawing || !form_->is_engraved()) return;
    const flat::FlatOptions wanted = form_->flat_options(context_.machine_profile());
    if (flat::flat_options_json(wanted) != flat::flat_options_json(context_.open_job.shape()))
        context_.open_job.reshape(wanted);
}

/// As the form has it.
void ModelPage::reload() {
    if (context_.open_job.kind() == flat::ModelKind::mesh)
        return context_.open_job.open(context_.open_job.path());
    context_.open_job.reshape(form_->flat_options(context_.machine_profile()));
}

void ModelPage::show_opened() {
    const auto scene = context_.open_job.scene();
    const bool is_other = opened_path_ != context_.open_job.path();
    if (scene == opened_ && !is_other) return;
    opened_ = scene;
    if (is_other) {
        opened_path_ = context_.open_job.path();
        piece_->choose_model();
        blank_warnings_.clear();
        turn_->begin_anew();
        form_->set_fits(false);
        form_->set_table(context_.open_job.table_way().has_value());
        form_->begin(context_.open_job.kind(), context_.open_job.shape().engraving.has_value());
    }
    view_->fit();
    look();
}

bool ModelPage::is_stale() const {
    const session::OpenJobView& job_view = context_.open_job.view();
    if (job_view.state != OpenJobState::job && job_view.state != OpenJobState::published) return false;
    const bool is_taken_over = context_.open_job.is_taken_over();
    // A table becomes a job without being asked for, too.
    if (const auto& way = context_.open_job.table_way()) return is_taken_over || !way->is_as(table_way());
    return context_.open_job.mesh() && (is_taken_over || changes_ != sliced_changes_);
}

ModelPage::Work ModelPage::work() const {
    return {values_of_fields(*fields_), context_.open_job.path(), fitted_blank_, changes_, sliced_changes_};
}

/// Nothing is opened, turned, reshaped or sliced: it is all there.
void ModelPage::take_work(const Work& kept) {
    is_taking_ = kept.path == context_.open_job.path();
    if (!is_taking_) return;  // another file has come
    opened_ = context_.open_job.scene();
    opened_path_ = kept.path;
    form_->set_table(context_.open_job.table_way().has_value());
    form_->begin(context_.open_job.kind(), context_.open_job.shape().engraving.has_value());
    put_into_fields(*fields_, kept.fields);
    form_->set_fits(turn_->fits());
    fitted_blank_ = kept.fitted_blank;
    changes_ = kept.changes;
    sliced_changes_ = kept.sliced_changes;
    is_taking_ = false;
    view_->fit();
    look();
}

}  // namespace psicarve::ui
