// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/machine/machine_link.hpp"

namespace psicarve::cli {

/// Watches a running job for the person at the terminal: a bar while it goes on, Ctrl-C passed on to the
/// core.
class RunWatch {
public:
    explicit RunWatch(machine::MachineLink& link) : link_(&link), bar_("starting") {}

    /// To be handed to a wait; outlived by this.
    machine::StatusWatch watch() {
        return [this](const CoreStatus& status) { return look(status); };
    }
    bool was_stopped() const noexcept { return operator_break_.was_asked(); }
    Error stop_error(const CoreStatus& last) const { return operator_break_.error(last); }

private:
    Result<void> look(const CoreStatus& status);

    machine::MachineLink* link_;
    ProgressBar bar_;
    OperatorBreak operator_break_;
};

}  // namespace psicarve::cli
