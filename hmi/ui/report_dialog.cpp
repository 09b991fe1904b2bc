// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/report_dialog.hpp"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <span>
#include <utility>

#include "hmi/cli/run_report.hpp"
#include "hmi/session/run_watch.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"
#include "shared/atomic_file.hpp"

namespace psicarve::ui {

ReportDialog::ReportDialog(machine::JobRun run, bool is_over, std::shared_ptr<const cam::PreparedJob> job,
                           session::MessageLog& log, QWidget* parent)
    : QDialog(parent), run_(std::move(run)), job_(std::move(job)), log_(log) {
    setObjectName("report");
    setWindowTitle(tr("Report"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* all = new QVBoxLayout{this};
    all->addWidget(role_label("title", QString::fromStdString(std::string{job_->view.source_name()})));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(3 * kGap);
    int line = 0;
    for (const session::ReportRow& row : session::run_rows(run_, is_over, job_->view.layer_count())) {
        grid->addWidget(role_label("label", words(row.name)), line, 0);
        auto* value = new QLabel{words(row.value)};
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        grid->addWidget(value, line++, 1, Qt::AlignRight);
    }
    all->addLayout(grid);
    auto* buttons = new QDialogButtonBox;
    QPushButton* save_button = buttons->addButton(tr("Save as JSON…"), QDialogButtonBox::ActionRole);
    QPushButton* close_button = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    connect(save_button, &QPushButton::clicked, this, [this] {
        const QString path =
            ask_where_to_save(this, tr("Save the report"), "report.json", tr("JSON (*.json)"));
        if (!path.isEmpty()) save(path);
    });
    connect(close_button, &QPushButton::clicked, this, [this] { close(); });
    all->addWidget(buttons);
}

void ReportDialog::save(const QString& path) {
    cli::RunReport report = cli::report_of(job_->view, run_);
    report.unverified_reason = "the window does not verify; psicarve carve does";
    const std::string text = cli::run_json(report) + "\n";
    const auto saved = write_file_atomically(path.toStdString(), std::as_bytes(std::span{text}));
    if (saved) {
        log_.add(session::Severity::info, session::phrase("Report saved: %1", path.toStdString()));
    } else {
        log_.add(session::Severity::warning, session::phrase("Report: %1", saved.error().message));
    }
}

}  // namespace psicarve::ui
