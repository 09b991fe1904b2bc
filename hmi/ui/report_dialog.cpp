// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/report_dialog.hpp"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

#include "hmi/report/run_report.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {

ReportDialog::ReportDialog(const session::RunWatch& runs, std::shared_ptr<const cam::PreparedJob> job,
                           std::optional<verify::VerifyReport> verdict, session::FileSaver& files,
                           QWidget* parent)
    : QDialog(parent), run_(*runs.run()), verdict_(std::move(verdict)), job_(std::move(job)), files_(files) {
    setObjectName("report");
    setWindowTitle(tr("Report"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* all = new QVBoxLayout{this};
    all->addWidget(role_label("title", QString::fromStdString(std::string{job_->view.source_name()})));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(3 * kGap);
    int line = 0;
    const auto is_verified = verdict_ ? std::optional{verdict_->ok} : std::nullopt;
    for (const session::ReportRow& row : session::run_rows(run_, runs.is_over(), job_->view.layer_count(),
                                                           is_verified, runs.seen_from_layer())) {
        grid->addWidget(role_label("label", words(row.name)), line, 0);
        auto* value = plain_label(words(row.value));
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        grid->addWidget(value, line++, 1, Qt::AlignRight);
    }
    all->addLayout(grid);
    auto* buttons = new QDialogButtonBox;
    QPushButton* save_button = buttons->addButton(tr("Save as JSON…"), QDialogButtonBox::ActionRole);
    QPushButton* close_button = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    save_button->setObjectName("report_save");
    close_button->setObjectName("report_close");
    connect(save_button, &QPushButton::clicked, this, [this] {
        const QString path =
            ask_where_to_save(this, tr("Save the report"), "report.json", tr("JSON (*.json)"));
        if (!path.isEmpty()) save(path);
    });
    connect(close_button, &QPushButton::clicked, this, [this] { close(); });
    all->addWidget(buttons);
}

void ReportDialog::save(const QString& path) {
    report::RunReport whole = report::report_of(job_->view, run_);
    whole.verification = verdict_;
    whole.unverified_reason =
        run_.after.is_dry != 0 ? "a dry run carves nothing" : "its pins were not recorded";
    files_.save_text(path.toStdString(), report::run_json(whole) + "\n");
}

}  // namespace psicarve::ui
