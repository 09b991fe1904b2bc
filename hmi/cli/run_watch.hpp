// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/job/job.hpp"

namespace psicarve::cli {

/// Watches a running job for the person at the terminal: shows a bar, and passes Ctrl-C on to the core.
class RunWatch {
public:
    /// `job`: the job being carved. All outlive this, `operator_break` until the report is printed.
    RunWatch(machine::MachineLink& link, const JobView& job, OperatorBreak& operator_break)
        : link_(&link), job_(&job), bar_("starting"), operator_break_(operator_break) {}

    /// For a wait; this object outlives it.
    machine::StatusWatch watch() {
        return [this](const CoreStatus& status) { return look(status); };
    }
    bool was_stopped() const noexcept { return operator_break_.was_asked(); }
    Error stop_error(const CoreStatus& last) const { return operator_break_.error(last); }

private:
    Result<void> look(const CoreStatus& status);
    void tell_remark();

    machine::MachineLink* link_;
    const JobView* job_;
    ProgressBar bar_;
    OperatorBreak& operator_break_;
    bool has_told_ = false;
};

}  // namespace psicarve::cli
