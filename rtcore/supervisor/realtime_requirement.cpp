// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/realtime_requirement.hpp"

#include <string>
#include <thread>
#include <vector>

#include "rtcore/realtime/rt_setup.hpp"

namespace psicarve::supervisor {

Result<void> require_realtime(const CoreOptions& options) {
    if (options.port.is_simulated() || options.allow_no_realtime) return {};
    std::vector<rtcore::SetupStep> steps;
    // A thread of its own, gone again: the tick's own makes itself ready later.
    std::thread{[&] { steps = rtcore::set_up_realtime_thread(options.priority, options.cpu); }}.join();
    for (const rtcore::SetupStep& step : steps) {
        if (step.outcome != rtcore::SetupStep::Outcome::refused) continue;
        return Error{ErrorCode::machine_refused, "a real port needs its " + std::string{name_of(step.step)} +
                                                     ": " + step.detail + "; " + step.remedy +
                                                     "; or --allow-no-realtime"};
    }
    return {};
}

}  // namespace psicarve::supervisor
