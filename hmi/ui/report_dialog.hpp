// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

#include <memory>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/machine/job_run.hpp"
#include "hmi/session/message_log.hpp"

namespace psicarve::ui {

/// What a run came to: pulses, times, alarms. A window of its own that hinders nothing.
class ReportDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ReportDialog)
public:
    ReportDialog(machine::JobRun run, bool is_over, std::shared_ptr<const cam::PreparedJob> job,
                 session::MessageLog& log, QWidget* parent);

    /// The same JSON as `psicarve carve --json`. Says how it went in the messages.
    void save(const QString& path);

private:
    machine::JobRun run_;
    std::shared_ptr<const cam::PreparedJob> job_;
    session::MessageLog& log_;
};

}  // namespace psicarve::ui
