// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include "hmi/machine/machine_link.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Ctrl-C (SIGINT) and SIGTERM while a command waits for a machine: the first asks the core to stop in order,
/// the second is an emergency stop, the third ends the waiting. Lives until the report is printed: a further
/// press while the core ends must not lose the report. One at a time; its destructor restores the old
/// handlers, and so does the third press.
class OperatorBreak {
public:
    OperatorBreak();
    ~OperatorBreak();
    OperatorBreak(const OperatorBreak&) = delete;
    OperatorBreak& operator=(const OperatorBreak&) = delete;

    /// The end of the terminal (SIGHUP) is one from here on, too, unless it was ignored, as by nohup.
    void take_hang_up();
    bool was_asked() const noexcept;
    /// How many signals came since the program began: also those that came too late for their own wait.
    static unsigned asked_ever() noexcept;
    /// Call it repeatedly while waiting: passes the request on to the core. `cancelled` once the waiting
    /// itself must end.
    Result<void> pass_on(machine::MachineLink& link);
    /// The waiting is over, and only the report is left: the third press ends the program from now on.
    void let_third_end_us() noexcept;
    /// The error of a wait that ended after a break.
    Error error(const CoreStatus& last) const;

private:
    int passed_on_ = 0;
    bool takes_hang_up_ = false;
};

}  // namespace psicarve::cli
