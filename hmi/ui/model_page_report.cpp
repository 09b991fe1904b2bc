// SPDX-License-Identifier: GPL-3.0-or-later
// What page Model tells of a model before it is carved: the piece to be expected, and the report.
#include <QLabel>
#include <QPushButton>

#include "hmi/session/display_text.hpp"
#include "hmi/session/job_facts.hpp"
#include "hmi/session/mesh_text.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/model_form.hpp"
#include "hmi/ui/model_page.hpp"
#include "hmi/ui/model_report_dialog.hpp"
#include "hmi/ui/piece_panel.hpp"
#include "hmi/ui/refusal_bar.hpp"

namespace psicarve::ui {

void ModelPage::refresh_piece() {
    const session::OpenJob& desk = context_.open_job;
    const Profile profile = form_->profile_for(context_.machine_profile());
    const bool is_engraved = desk.mesh() && desk.mesh()->grooves;
    const session::PieceChoice choice =
        session::piece_choice(desk.job() != nullptr, desk.mesh() != nullptr, is_engraved, profile.tool.shape);
    no_piece_ = choice.reason;
    const bool is_of_job = choice.source == session::PieceSource::job;
    piece_->refresh(
        choice,
        session::PieceRequest{desk.job(), is_of_job ? desk.job_mesh() : desk.mesh(), profile, options()},
        report_ != nullptr);
}

void ModelPage::open_report() {
    if (report_ == nullptr) report_ = new ModelReportDialog{this};
    refresh_report();
    report_->show();
    report_->raise();
}

/// As it becomes known. Without a mesh there is nothing to be told.
void ModelPage::refresh_report() {
    const auto mesh = context_.open_job.mesh();
    if (report_ == nullptr) return;
    if (!mesh) {
        report_->close();
        return;
    }
    const auto seen = watch_.seen();
    const auto findings = watch_.findings();
    const auto piece = piece_->desk().view();
    const session::Phrase& problem = piece_->desk().problem();
    report_->show_rows(QString::fromStdString(mesh->source_name),
                       session::model_rows({*mesh, seen ? &seen->reach : nullptr, findings.get(), piece.get(),
                                            no_piece_.is_empty() ? problem : no_piece_, sliced_undercut()}));
}

/// One figure everywhere: the slicer's of the job's own layers and points, as its warnings and `psicarve
/// inspect` have it. Nothing until the model is sliced as it stands in the form.
std::optional<double> ModelPage::sliced_undercut() {
    const auto job = context_.open_job.job();
    if (!job || context_.open_job.job_mesh() != context_.open_job.mesh() || is_stale()) return std::nullopt;
    if (counted_job_ != job) {
        counted_job_ = job;
        counted_share_ = session::job_facts(job->view).undercut_share;
    }
    return counted_share_;
}

void ModelPage::show_legend() {
    if (!shown_view_ || piece_->is_chosen()) return;
    const auto sliced = sliced_undercut();
    const auto entry = [](QRgb rgb, const QString& text) {
        return QStringLiteral("<span style='color:%1'>■</span> %2").arg(QColor::fromRgb(rgb).name(), text);
    };
    constexpr double kPercent = 100.0;
    const double share = sliced.value_or(shown_view_->reach.undercut_share);
    const QString percent = QString::fromStdString(session::number_text(kPercent * share, 1));
    const QString undercut =
        sliced ? tr("undercut %1 %").arg(percent) : tr("undercut about %1 %").arg(percent);
    const QString text = entry(kReachable_rgb, tr("reachable")) + "<br>" + entry(kUndercut_rgb, undercut);
    if (legend_ == text) return;
    legend_ = text;
    view_->set_legend(text);
}

/// What is locked says why.
void ModelPage::show_reasons() {
    const bool has_mesh = context_.open_job.mesh() != nullptr;
    lock_with(*report_button_, has_mesh ? QString{} : tr("Report: open a model first"),
              tr("What the mesh is made of, what is wrong with it and what no tool reaches"));
    lock_with(*show_hidden_,
              !has_mesh                   ? tr("Undercut: open a model first")
              : piece_->is_chosen()       ? tr("Undercut: choose Model first")
              : !shown_view_              ? tr("Undercut: it is being looked for")
              : !shown_view_->hidden_view ? tr("Undercut: there is none")
                                          : QString{},
              tr("From where most of the undercut is seen"));
}

/// In the view's place, while there is nothing to be seen.
void ModelPage::show_why_empty() {
    const session::RefusedFile* const refused = context_.refused_file();
    const QString usual = tr("No model. Open one from the menu, or drop a file here.");
    const QString text = refused == nullptr
                             ? usual
                             : QStringLiteral("%1\n%2\n\n%3")
                                   .arg(RefusalBar::title_of(*refused), RefusalBar::why_of(*refused), usual);
    if (why_empty_ == text) return;
    why_empty_ = text;
    view_->set_empty_text(text);
}

}  // namespace psicarve::ui
