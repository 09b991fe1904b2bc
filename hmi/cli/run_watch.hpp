// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/job/job.hpp"

namespace psicarve::cli {

/// Watches a running job for the person at the terminal: a bar while it goes on, Ctrl-C passed on to the
/// core.
class RunWatch {
public:
    /// `job`: what is carved. All outlive this, `operator_break` until the report is out.
    RunWatch(machine::MachineLink& link, const JobView& job, OperatorBreak& operator_break)
        : link_(&link), job_(&job), bar_("starting"), operator_break_(operator_break) {}

    /// To be handed to a wait; outlived by this.
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
