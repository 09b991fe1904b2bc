// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include "hmi/machine/machine_link.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Ctrl-C (SIGINT) and SIGTERM while we wait for a machine: the first asks the core to stop in order, the
/// second is an emergency stop, the third ends the waiting. Lives until the report is out: whoever presses
/// once more while the core ends is not to lose it. One at a time; with its end the old behaviour returns,
/// once asked for the third.
class OperatorBreak {
public:
    OperatorBreak();
    ~OperatorBreak();
    OperatorBreak(const OperatorBreak&) = delete;
    OperatorBreak& operator=(const OperatorBreak&) = delete;

    bool was_asked() const noexcept;
    /// How often any of them was asked since the program began: also what came too late for its own wait.
    static unsigned asked_ever() noexcept;
    /// To be called again and again while waiting: passes what was asked on to the core. `cancelled` once the
    /// waiting itself is to end.
    Result<void> pass_on(machine::MachineLink& link);
    /// The waiting is over, and what is left is the report: the third ends the program from now on.
    void let_third_end_us() noexcept;
    /// What a wait that ended after a break failed with.
    Error error(const CoreStatus& last) const;

private:
    int passed_on_ = 0;
};

}  // namespace psicarve::cli
