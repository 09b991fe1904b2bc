// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

#include <memory>
#include <optional>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/machine/job_run.hpp"
#include "hmi/session/file_saver.hpp"
#include "hmi/session/run_watch.hpp"
#include "hmi/verify/verify_report.hpp"

namespace psicarve::ui {

/// What a run came to: pulses, times, alarms. A window of its own that hinders nothing.
class ReportDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ReportDialog)
public:
    /// Of the run that `runs` tells of; there must be one.
    ReportDialog(const session::RunWatch& runs, std::shared_ptr<const cam::PreparedJob> job,
                 std::optional<verify::VerifyReport> verdict, session::FileSaver& files, QWidget* parent);

    /// The same JSON as `psicarve carve --json`. Says how it went in the messages.
    void save(const QString& path);

private:
    machine::JobRun run_;
    std::optional<verify::VerifyReport> verdict_;
    std::shared_ptr<const cam::PreparedJob> job_;
    session::FileSaver& files_;
};

}  // namespace psicarve::ui
